use nalgebra::{DMatrix, DVector, Vector3};

use super::rows::SampleSensors;
use super::{SensorLayout, Swivel, Weights};
use crate::residual::Latent;
use crate::residual::balance::rows::RowModel;
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::measurement::{InternalSamples, Samples, SensorSigmas};
use cdpr_model::model::{Composition, FreeParameters, Model};
use cdpr_model::robot::{Frame, Parameter, ParameterKind, Robot, TrackedFrames};
use cdpr_model::statics::Load;

/// Four elastic cables over swivelling pulleys hold a platform of six degrees of freedom.
fn hanging() -> Model {
    let cable = |k: usize| {
        let (x, y): (f64, f64) = ([1.0, 1.1, -1.0, -1.2][k], [-1.1, 1.0, 1.2, -1.0][k]);
        format!(
            "[[cable]]\nname = \"{k}\"\nframe_anchor_m = [{x:?}, {y:?}, 1.8]\nplatform_anchor_m = [{}, {}, 0.2]\n\
             pulley_radius_m = 0.03\npulley_swivel_axis = [{}, 0.0993808, 0.0496904]\naxial_stiffness_EA_N = 2e4\n",
            0.1 * x,
            0.08 * y,
            0.993808 * x.signum()
        )
    };
    let cables: String = (0..4).map(cable).collect();
    let text = format!(
        "layout_version = 1\nname = \"hanging\"\nmotion_pattern = \"3R3T\"\ncable_count = 4\ngravity_m_s2 = [0.0, 0.0, -9.81]\n\
         [platform]\nmass_kg = 12.0\ncenter_of_mass_m = [0.01, -0.02, 0.1]\n[home_pose]\nposition_m = [0.0, 0.0, 0.6]\n\
         rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]\n{cables}"
    );
    Model::new(Robot::from_toml(&text, "hanging.toml").unwrap(), Composition { pulley: true, ..Composition::ELASTIC })
        .unwrap()
}

fn measured() -> (InternalSamples, Latent) {
    let pose = Pose::from_xyz_angles(Vector3::new(0.1, -0.2, 0.5), [0.1, -0.05, 0.2]);
    let samples = Samples {
        poses: vec![Pose::from_xyz_angles(Vector3::zeros(), [0.12, -0.06, 0.17])],
        lengths: vec![1.7, 1.9, 1.8, 1.6],
        tensions: Some(vec![40.0, 35.0, 45.0, 30.0]),
        cable_count: 4,
        sigmas: SensorSigmas { rotation: Some(0.01), ..SensorSigmas::default() },
        ..Samples::default()
    };
    let internal = InternalSamples {
        known: vec![vec![false, false, false, true, true, true]],
        swivels: Some(vec![0.6, -0.6, 0.5, -0.7]),
        masses: None,
        facts: Vec::new(),
        are_changes: false,
        samples,
    };
    (internal, Latent { pose, tensions: vec![41.0, 36.0, 44.0, 31.0] })
}

/// Derivatives of all rows of a sample by pose, tensions, parameters and frames are their differences.
#[test]
fn derivatives_of_all_rows_are_their_differences() {
    let mut robot = hanging().robot().clone();
    robot.tracked = Some(TrackedFrames {
        tracker: Frame { position: Vector3::new(0.02, 0.01, -0.03), turn: Vector3::new(0.03, -0.02, 0.01) },
        marker: Frame { position: Vector3::new(0.2, -0.1, 0.15), turn: Vector3::new(-0.01, 0.03, 0.02) },
    });
    let model = Model::new(robot, hanging().composition()).unwrap();
    let (mut internal, at) = measured();
    internal.known = vec![vec![true; 6]];
    internal.samples.poses = vec![Pose::from_xyz_angles(Vector3::new(0.3, -0.3, 0.7), [0.12, -0.06, 0.17])];
    internal.samples.sigmas.position = Some(0.002);
    let free: FreeParameters =
        "frame-anchor,platform-anchor,length-offset,length-scale,pulley-radius,swivel-axis,compliance,\
                                tension-scale,tension-offset,mass,center-of-mass"
            .parse()
            .unwrap();
    let mut parameters = free.parameters(&model, &FreeParameters::default()).unwrap();
    for kind in [ParameterKind::TrackerFrame, ParameterKind::MarkerFrame] {
        parameters.extend((0..6).map(|axis| Parameter { cable: 0, kind, axis }));
    }
    let weights = Weights::new(&model, &internal.samples.sigmas, 37.5);
    let layout = SensorLayout::of(&model, &internal, true, &weights);
    let directions = [model.twist_basis().to_vec()];
    let sensors = SampleSensors { internal: &internal, layout: &layout, weights: &weights, directions: &directions };
    assert_eq!(layout.size(), 4 + 4 + 6 + 4 + 6);
    let residuals = |model: &Model, at: &Latent| -> DVector<f64> {
        let rows = RowModel::new(model, Load::of(model.robot()).unwrap(), &[]);
        sensors.rows(&rows, 0, at).unwrap().residuals
    };
    let bare = RowModel::new(&model, Load::of(model.robot()).unwrap(), &[]);
    let rows = RowModel::new(&model, Load::of(model.robot()).unwrap(), &parameters);
    let analytic = sensors.rows(&bare, 0, &at).unwrap();
    // central differences: truncation ~ h², rounding ~ the largest residual (1e4 standard deviations of equilibrium) · ε/h
    let assert_near = |slope: &DVector<f64>, column: DVector<f64>, what: &str| {
        let away = (slope - &column).amax();
        assert!(away < 1e-6 * column.amax().max(1.0) + 1e-4, "{what}: {away}");
    };
    for k in 0..10 {
        let moved = |amount: f64| {
            let mut latent = at.clone();
            match k {
                0..6 => latent.pose = at.pose.displaced(&Twist::ith(k, amount)),
                cable => latent.tensions[cable - 6] += amount,
            }
            residuals(&model, &latent)
        };
        let h = if k < 6 { 1e-6 } else { 1e-4 };
        let slope = (moved(h) - moved(-h)) / (2.0 * h);
        assert_near(&slope, analytic.by_latent.column(k).into_owned(), &format!("unknown {k}"));
    }
    let by_parameters: DMatrix<f64> = sensors.by_parameters(&rows, &parameters, 0, &at).unwrap();
    for (k, parameter) in parameters.iter().enumerate() {
        let moved = |amount: f64| {
            let value = parameter.value(model.robot()) + amount;
            residuals(&model.with_parameters(&[*parameter], &[value]).unwrap(), &at)
        };
        let largest: f64 = by_parameters.column(k).amax();
        let h = 1e-2 / largest.max(1e3);
        let slope = (moved(h) - moved(-h)) / (2.0 * h);
        for (first, count) in [(0, 4), (4, 4), (8, 6), (14, 4), (18, 6)] {
            let own = by_parameters.column(k).rows(first, count).into_owned();
            let away = (slope.rows(first, count) - &own).amax() / own.amax().max(1e-3 * largest);
            assert!(away < 1e-4, "{} rows {first}: {away}", Parameter::name(parameter, model.robot()));
        }
    }
}

/// The angle is 0 where the platform anchor hangs below the axis, and grows right-handed about it.
#[test]
fn swivel_angles_count_from_gravity() {
    let model = hanging();
    let below = |cable: usize| {
        let own = &model.robot().cables[cable];
        Pose::from_xyz_angles(own.frame_anchor - own.platform_anchor - Vector3::z(), [0.0; 3])
    };
    for cable in 0..4 {
        let (pose, axis) = (below(cable), **model.robot().cables[cable].swivel_axis().as_ref().unwrap());
        let swivel = Swivel::of(&model, cable, &pose).unwrap();
        assert!(swivel.angle.abs() < 1e-12, "{}", swivel.angle);
        let turned = pose.displaced(&{
            let way = axis.cross(&-Vector3::z()) * 0.1;
            Twist::new(way.x, way.y, way.z, 0.0, 0.0, 0.0)
        });
        assert!(Swivel::of(&model, cable, &turned).unwrap().angle > 0.05);
        assert!((Swivel::of(&model, cable, &turned).unwrap().minus(6.0) + 6.0 - std::f64::consts::TAU).abs() < 0.2);
    }
}

/// A search from the pose of another sample keeps the height that the sample's own probe states exactly.
#[test]
fn searches_from_other_poses_keep_what_a_sample_knows_exactly() {
    let model = hanging();
    let (mut internal, _) = measured();
    let at = |z: f64| Pose::from_xyz_angles(Vector3::new(0.0, 0.0, z), [0.0; 3]);
    internal.samples.poses = vec![at(0.45), at(0.6)];
    internal.samples.lengths = internal.samples.lengths.repeat(2);
    internal.samples.tensions = None;
    internal.samples.sigmas = SensorSigmas::default();
    internal.swivels = None;
    internal.known = vec![vec![false, false, true, false, false, false]; 2];
    let weights = Weights::new(&model, &internal.samples.sigmas, 37.5);
    let layout = SensorLayout::of(&model, &internal, false, &weights);
    let sensors = super::SensorResidual::new(&model, &internal, &[], &layout, &weights);
    let near = Pose::from_xyz_angles(Vector3::new(0.1, -0.2, 0.45), [0.1, -0.05, 0.2]);
    let placed = sensors.placed(1, &near).pose;
    assert_eq!(placed.position, Vector3::new(0.1, -0.2, 0.6));
    assert_eq!(placed.rotation, near.rotation);
}
