//! Outlines of what is reached, and how a change moves them, as a picture.

use cdpr_study::Experiment;
use cdpr_study::reachable::Image;
use cdpr_workspace::Point;
use cdpr_workspace::hull::Hull;

use super::Differential;
use crate::answers::{axis_names, components, control_title, title};
use crate::figures::{Look, Outline, Outlines};
use crate::number_format::{fixed, short};

/// Contents of the picture.
pub struct Picture<'a> {
    /// Control model and machine.
    pub experiment: &'a Experiment,
    /// Workspace in which the machine is wrench-feasible.
    pub physical: Option<&'a Hull>,
    /// Poses that are reached.
    pub hull: &'a Hull,
    /// Poses where the platform comes to rest.
    pub image: Option<&'a Image>,
    /// A change of one number.
    pub differential: Option<&'a Differential>,
}

impl Picture<'_> {
    /// SVG of the picture; `None` if nothing is reached.
    pub fn svg(&self) -> Option<String> {
        self.outlines().svg().map(|picture| picture.file())
    }

    fn outlines(&self) -> Outlines {
        let robot = self.experiment.machine.robot();
        let names = axis_names(robot);
        let center = self.hull.center;
        let words = |point: &Point| {
            let parts: Vec<String> = point[..self.hull.dimension()].iter().map(|part| short(*part)).collect();
            parts.join(", ")
        };
        let anchors = robot.cables.iter().enumerate().map(|(index, cable)| {
            let at = components(robot, &cable.frame_anchor);
            ((index + 1).to_string(), [at[0], at[1]])
        });
        Outlines {
            title: self.title(&names),
            axes: [names[0].clone(), names[1].clone()],
            outlines: self.all(),
            arrows: self.arrows(),
            // those of a spatial robot lie far above and below the section
            points: if self.is_planar() { anchors.collect() } else { Vec::new() },
            center: (format!("center of the rays, ({}) m", words(&center)), [center[0], center[1]]),
        }
    }

    fn is_planar(&self) -> bool {
        self.hull.dimension() == 2
    }

    fn title(&self, names: &[String]) -> Vec<String> {
        let changed = self.differential.map(|change| {
            let unit = if change.unit == "1" { String::new() } else { format!(" {}", change.unit) };
            format!("What is reached, and how it moves with {} changed by {}{unit}", change.parameter, change.change)
        });
        let experiment = self.experiment;
        let mut lines = vec![
            changed.unwrap_or_else(|| "What is reached, by commanded and by emerging poses".to_owned()),
            format!("{} drives {}", control_title(experiment), title(&experiment.machine)),
        ];
        if !self.is_planar() {
            let (axis, height) = (&names[2], short(self.hull.center[2]));
            lines.push(format!(
                "section at {axis} = {height} m of the surface of {} rays; sizes are those of the volumes",
                self.hull.radii.len()
            ));
        }
        if !self.hull.is_star_shaped() {
            let rays = self.hull.rays_again;
            lines.push(format!("not the whole boundary: {rays} rays enter the region again after they have left it"));
        }
        lines
    }

    /// From back to front.
    fn all(&self) -> Vec<Outline> {
        let plane = |points: Vec<Point>| points.into_iter().map(|[x, y, _]| [x, y]).collect();
        let named = |name: &str, look: Look, hull: &Hull| {
            let size = hull.measure().filter(|_| hull.is_star_shaped()).map(|measure| measure.size);
            Outline { name: self.with_size(name, size), look, points: plane(hull.section()) }
        };
        let physical = self.physical.map(|hull| named("physical", Look::Background, hull));
        let mut all: Vec<Outline> = physical.into_iter().collect();
        let Some(change) = self.differential else {
            // the image of a section is no plane
            let image = self.image.filter(|_| self.is_planar()).map(|image| Outline {
                name: self.with_size("reached, by emerging poses", Some(image.size)),
                look: Look::FirstOrder,
                points: plane(image.vertices.clone()),
            });
            all.push(named("reached, by commanded poses", Look::Nominal, self.hull));
            all.extend(image);
            return all;
        };
        all.push(named("reached", Look::Nominal, self.hull));
        all.extend(change.anew.as_ref().map(|hull| named("changed, found anew", Look::Changed, hull)));
        all.push(named("changed, to first order", Look::FirstOrder, &change.moved));
        all
    }

    fn with_size(&self, name: &str, size: Option<f64>) -> String {
        let unit = if self.is_planar() { "m²" } else { "m³" };
        size.map_or_else(|| name.to_owned(), |size| format!("{name}: {} {unit}", fixed(size, 2)))
    }

    /// From the boundary to where it moves; without a change from what is commanded to what emerges.
    fn arrows(&self) -> (String, Vec<[[f64; 2]; 2]>) {
        let from = self.hull.section();
        let (name, to) = match (self.differential, self.image) {
            (Some(change), _) => ("how the boundary moves, to first order", change.moved.section()),
            (None, Some(image)) if self.is_planar() => ("from commanded to emerging", image.vertices.clone()),
            _ => return (String::new(), Vec::new()),
        };
        let pairs = from.iter().zip(&to).map(|(from, to)| [[from[0], from[1]], [to[0], to[1]]]);
        (name.to_owned(), pairs.collect())
    }
}
