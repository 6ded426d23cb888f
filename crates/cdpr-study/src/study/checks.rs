//! Checks of a study file; each error names its key.

use super::published::STAGES;
use super::{CampaignTable, PoseGrid, PublishedStage, RandomPoses, Study, Task, TensionTests, Tolerances};
use cdpr_model::model::Composition;
use cdpr_model::reading::Keyword;
use cdpr_model::reading::{ReadError, Step, TomlDocument};

/// Most poses of a study.
const POSE_LIMIT: usize = 1_000_000;

/// Checks a study; the error is at the wrong value.
pub(super) fn check(study: &Study, document: &TomlDocument<'_>) -> Result<(), ReadError> {
    let place = Place { document };
    check_models(study, &place)?;
    check_initial(study, &place)?;
    check_limits(study, &place)?;
    if study.history.is_some_and(|history| !(1..=1000).contains(&history.sub_steps)) {
        return Err(place.error(&["history", "sub_steps"], "sub_steps is a whole number from 1 to 1000".to_owned()));
    }
    if let Some(tests) = study.poses.as_ref().and_then(|poses| poses.tension_tests.as_ref()) {
        check_tension_tests(study, tests, &place)?;
    }
    if let Some(tolerances) = &study.tolerances {
        check_tolerances(tolerances, &place)?;
    }
    if let Some(campaign) = &study.campaign {
        check_campaign(campaign, &place)?;
    }
    if let Some(Task { min, max }) = &study.task {
        // written so that NaN is refused too; a planar robot's box has no depth
        let is_box = min.iter().zip(max).all(|(min, max)| min <= max && (max - min).is_finite());
        if !is_box || min == max {
            return Err(
                place.error(&["task", "max"], "max is above min in some directions, and below in none".to_owned())
            );
        }
    }
    check_published(&study.published, &place)?;
    check_poses(study, &place)
}

fn check_published(published: &[PublishedStage], place: &Place<'_>) -> Result<(), ReadError> {
    for (index, own) in published.iter().enumerate() {
        let wrong = |key: &str, message: String| {
            let steps = [Step::Key("published"), Step::Index(index), Step::Key(key)];
            Err(place.document.error_at(&steps, "study::value", message))
        };
        if !STAGES.contains(&own.stage.as_str()) {
            let message = format!("`{}` is no stage of the chain; there are {}", own.stage, STAGES.join(", "));
            return wrong("stage", message);
        }
        if published[..index].iter().any(|other| other.stage == own.stage) {
            return wrong("stage", format!("the stage `{}` stands twice", own.stage));
        }
        for (key, error) in own.errors() {
            // written so that NaN is refused too
            if error.is_some_and(|error| !(error >= 0.0 && error.is_finite())) {
                return wrong(key, format!("{key} is a finite number of 0 or more"));
            }
        }
    }
    Ok(())
}

fn check_campaign(campaign: &CampaignTable, place: &Place<'_>) -> Result<(), ReadError> {
    let wrong = |key: &str, message: &str| Err(place.error(&["campaign", key], format!("{key} {message}")));
    if campaign.poses_per_round == 0 {
        return wrong("poses_per_round", "is 1 at least");
    }
    if !(1..=1000).contains(&campaign.rounds) {
        return wrong("rounds", "is a whole number from 1 to 1000");
    }
    if campaign.budget == Some(0) {
        return wrong("budget", "is 1 pose at least");
    }
    if campaign.accuracy_m.is_some_and(|accuracy| !(accuracy > 0.0 && accuracy.is_finite())) {
        return wrong("accuracy_m", "is a length above 0 m");
    }
    Ok(())
}

/// Makes errors at keys of the file.
struct Place<'a> {
    document: &'a TomlDocument<'a>,
}

impl Place<'_> {
    fn error(&self, path: &[&str], message: String) -> ReadError {
        let steps: Vec<Step<'_>> = path.iter().map(|key| Step::Key(key)).collect();
        self.document.error_at(&steps, "study::value", message)
    }
}

fn check_models(study: &Study, place: &Place<'_>) -> Result<(), ReadError> {
    let prediction = study.prediction.as_ref().map(|side| ("prediction", side));
    for (section, side) in
        [("control", &study.control.robot_model()), ("machine", &study.machine)].into_iter().chain(prediction)
    {
        if let Err(reason) = side.model.parse::<Composition>() {
            return Err(place.error(&[section, "model"], reason.to_string()));
        }
    }
    Ok(())
}

fn check_initial(study: &Study, place: &Place<'_>) -> Result<(), ReadError> {
    let initial = &study.initial;
    if let Some(word) = initial.offset.as_ref().filter(|word| *word != "none") {
        let message = format!("`{word}` is not an offset; the only word is \"none\"");
        return Err(place.error(&["initial", "offset"], message));
    }
    let choices = [initial.offset.is_some(), initial.offset_m.is_some(), initial.offset_robot.is_some()];
    if choices.iter().filter(|&&chosen| chosen).count() > 1 {
        let message = "offset, offset_m and offset_robot exclude each other".to_owned();
        return Err(place.error(&["initial"], message).with_help("keep one of them"));
    }
    if let Some([low, high]) = initial.tension_limits_N {
        let error = |message: String| Err(place.error(&["initial", "tension_limits_N"], message));
        if initial.tension_method.is_none() {
            return error("tension_limits_N is what a tension_method aims between, but there is none".to_owned());
        }
        if !(0.0 <= low && low <= high && high.is_finite()) {
            return error(format!(
                "tension_limits_N are a least and a largest tension in order, found {low} and {high}"
            ));
        }
    }
    if initial.tensions_N.is_some() && initial.tension_method.is_some() {
        let message = "tensions_N and tension_method exclude each other".to_owned();
        return Err(place.error(&["initial"], message).with_help("keep one of them"));
    }
    for (key, numbers) in [("tensions_N", &initial.tensions_N), ("offset_m", &initial.offset_m)] {
        let is_wrong = |value: &f64| !value.is_finite() || (key == "tensions_N" && *value < 0.0);
        if let Some(index) = numbers.as_ref().and_then(|numbers| numbers.iter().position(is_wrong)) {
            let message = format!("cable {}: {key} is a finite number, and a cable cannot push", index + 1);
            return Err(place.error(&["initial", key], message));
        }
    }
    Ok(())
}

fn check_limits(study: &Study, place: &Place<'_>) -> Result<(), ReadError> {
    let Some(limits) = &study.limits else { return Ok(()) };
    for (key, value) in [
        ("tension_min_N", limits.tension_min_N),
        ("tension_max_N", limits.tension_max_N),
        ("position_error_max_m", limits.position_error_max_m),
        ("rotation_error_max_rad", limits.rotation_error_max_rad),
        ("tension_error_max_N", limits.tension_error_max_N),
    ] {
        // written so that NaN is refused too
        if value.is_some_and(|value| !(value >= 0.0 && value.is_finite())) {
            return Err(place.error(&["limits", key], format!("{key} is a finite number of 0 or more")));
        }
    }
    match (limits.tension_min_N, limits.tension_max_N) {
        (Some(min), Some(max)) if min > max => {
            Err(place.error(&["limits", "tension_min_N"], format!("tension_min_N {min} is above tension_max_N {max}")))
        }
        _ => Ok(()),
    }
}

fn check_tolerances(tolerances: &Tolerances, place: &Place<'_>) -> Result<(), ReadError> {
    for (side, _, key, sigma) in tolerances.entries() {
        // written so that NaN is refused too
        if !(sigma >= 0.0 && sigma.is_finite()) {
            let message = format!("{key} is a standard deviation, a finite number of 0 or more, found {sigma}");
            return Err(place.error(&["tolerances", side.name(), key], message));
        }
    }
    if !(1..=1_000_000).contains(&tolerances.robots) {
        let message = "robots is a whole number from 1 to 1000000".to_owned();
        return Err(place.error(&["tolerances", "robots"], message));
    }
    if !(0.1..=10.0).contains(&tolerances.sigmas) {
        return Err(place.error(&["tolerances", "sigmas"], "sigmas is a number from 0.1 to 10".to_owned()));
    }
    // written so that NaN is refused too
    if tolerances.accuracy_m.is_some_and(|accuracy| !(accuracy > 0.0 && accuracy.is_finite())) {
        return Err(place.error(&["tolerances", "accuracy_m"], "accuracy_m is a finite number above 0".to_owned()));
    }
    Ok(())
}

fn check_tension_tests(study: &Study, tests: &TensionTests, place: &Place<'_>) -> Result<(), ReadError> {
    let path = ["poses", "tension_tests"];
    if tests.count > 0 && !study.machine.needs_tensions() {
        let message = format!("tension tests need an elastic machine; its model is `{}`", study.machine.model);
        return Err(place
            .error(&path, message)
            .with_help("write model = \"elastic\" in [machine], or remove [poses.tension_tests]"));
    }
    if !(tests.shorten_m > 0.0 && tests.shorten_m.is_finite()) {
        let message = format!("shorten_m is a finite number above 0, found {}", tests.shorten_m);
        return Err(place.error(&["poses", "tension_tests", "shorten_m"], message));
    }
    Ok(())
}

fn check_poses(study: &Study, place: &Place<'_>) -> Result<(), ReadError> {
    let Some(poses) = &study.poses else { return Ok(()) };
    let points = match &poses.grid {
        None => 0,
        Some(grid) => {
            check_grid(grid, &|message| place.error(&["poses", "grid"], message))?;
            grid.count.iter().try_fold(1_usize, |all, &count| all.checked_mul(count)).unwrap_or(usize::MAX)
        }
    };
    if let Some(random) = &poses.random {
        check_random(random, poses.grid.as_ref(), &|message| place.error(&["poses", "random"], message))?;
    }
    let random = poses.random.as_ref().map_or(0, |random| random.count);
    match points.saturating_add(random) > POSE_LIMIT {
        true => Err(place.error(&["poses"], format!("the study asks for more than {POSE_LIMIT} poses"))),
        false => Ok(()),
    }
}

fn check_random(
    random: &RandomPoses,
    grid: Option<&PoseGrid>,
    error: &dyn Fn(String) -> ReadError,
) -> Result<(), ReadError> {
    if random.min.is_some() != random.max.is_some() {
        return Err(error("a box has two corners: min and max".to_owned()));
    }
    match random.corners(grid) {
        Some([min, max]) => check_corners(min, max, error),
        None => Err(error("random poses need a box: add min and max here, or [poses.grid]".to_owned())),
    }
}

fn check_corners(min: &[f64], max: &[f64], error: &dyn Fn(String) -> ReadError) -> Result<(), ReadError> {
    if min.len() != max.len() {
        return Err(error(format!("min has {} components, max {}; they must be equally many", min.len(), max.len())));
    }
    for (index, (min, max)) in min.iter().zip(max).enumerate() {
        if !(min <= max) {
            return Err(error(format!("component {}: min {min} is above max {max}", index + 1)));
        }
    }
    Ok(())
}

fn check_grid(grid: &PoseGrid, error: &dyn Fn(String) -> ReadError) -> Result<(), ReadError> {
    let (dimension, max, count) = (grid.min.len(), grid.max.len(), grid.count.len());
    if max != dimension || count != dimension {
        return Err(error(format!(
            "min has {dimension} components, max {max}, count {count}; they must be equally many"
        )));
    }
    check_corners(&grid.min, &grid.max, error)
}
