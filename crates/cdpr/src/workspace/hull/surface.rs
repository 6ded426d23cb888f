//! A hull as a surface with values at its vertices.

use super::Hull;
use crate::workspace::Region;
use crate::workspace::mesh::{Field, Mesh};

impl Hull {
    /// The faces in the world; in a plane the triangles between centre and outline. Each vertex has the margin of the
    /// criterion and the number of the cable that limits there.
    pub fn mesh(&self, region: &Region<'_>) -> Mesh {
        let mut points = self.vertices();
        let mut triangles = self.faces.clone();
        if self.dimension == 2 {
            let center = points.len() as u32;
            points.push(self.center);
            triangles.iter_mut().for_each(|face| *face = [center, face[0], face[1]]);
        }
        let verdicts: Vec<_> = points.iter().map(|point| region.judge(point)).collect();
        // what no change would mend has no finite margin
        let finite = |margin: f64| margin.clamp(-f64::MAX, f64::MAX);
        let cable = |cable: Option<usize>| cable.map_or(0.0, |cable| (cable + 1) as f64);
        let fields = vec![
            Field {
                name: "margin".to_owned(),
                unit: region.criterion().unit().to_owned(),
                values: verdicts.iter().map(|verdict| finite(verdict.margin)).collect(),
            },
            Field {
                name: "limiting cable".to_owned(),
                unit: String::new(),
                values: verdicts.iter().map(|verdict| cable(verdict.cable)).collect(),
            },
        ];
        Mesh { vertices: points.iter().map(|point| region.position(point).into()).collect(), triangles, fields }
    }
}
