//! An SVG with panels: axes, curves, and maps as colour bands whose edges are contours with their values.

use std::fmt::Write;

use cdpr_reports::figures::colour;

/// Parts into which a cell of a map is cut, so that bands are smooth.
const FINENESS: usize = 4;

/// A picture under construction; coordinates in pixels from the upper left corner.
pub struct Picture {
    body: String,
    width: f64,
    height: f64,
    title: String,
}

/// A rectangle of the picture with its axes.
pub struct Panel {
    /// Upper left.
    pub corner: (f64, f64),
    /// Width and height.
    pub size: (f64, f64),
    /// From, to, in the unit of its axis.
    pub x: (f64, f64),
    /// From, to, in the unit of its axis.
    pub y: (f64, f64),
    /// Both axes by ratio.
    pub is_logarithmic: bool,
}

/// Values on a grid, row by row along y; NaN where there is none.
pub struct Grid {
    /// Columns.
    pub x: Vec<f64>,
    /// Rows.
    pub y: Vec<f64>,
    /// One for each row and column.
    pub values: Vec<f64>,
}

/// Parts of one band beside each other, not drawn yet: from their upper left to their lower right corner (pixels).
#[derive(Clone, Copy)]
struct Run {
    band: usize,
    from: (f64, f64),
    to: (f64, f64),
}

impl Panel {
    /// Pixels of a point.
    pub fn place(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let share = |value: f64, (low, high): (f64, f64)| match self.is_logarithmic {
            true => (value / low).ln() / (high / low).ln(),
            false => (value - low) / (high - low),
        };
        (self.corner.0 + self.size.0 * share(x, self.x), self.corner.1 + self.size.1 * (1.0 - share(y, self.y)))
    }
}

impl Grid {
    /// The value between the grid's points, by shares of a cell.
    fn between(&self, cell: (usize, usize), share: (f64, f64)) -> f64 {
        let at = |dx: usize, dy: usize| self.values[(cell.1 + dy) * self.x.len() + cell.0 + dx];
        let along = |dy: usize| at(0, dy) * (1.0 - share.0) + at(1, dy) * share.0;
        along(0) * (1.0 - share.1) + along(1) * share.1
    }

    fn point(&self, cell: (usize, usize), share: (f64, f64)) -> (f64, f64) {
        let between = |list: &[f64], k: usize, share: f64| list[k] * (1.0 - share) + list[k + 1] * share;
        (between(&self.x, cell.0, share.0), between(&self.y, cell.1, share.1))
    }
}

impl Picture {
    /// An empty picture; its title is read aloud to those who do not see it.
    pub fn new(width: f64, height: f64, title: &str) -> Self {
        Self { body: String::new(), width, height, title: title.to_owned() }
    }

    /// Text whose start, middle or end (the anchor) stands at a place.
    pub fn text(&mut self, anchor: &str, (x, y): (f64, f64), text: &str) {
        self.push(&format!(r#"<text text-anchor="{anchor}" x="{x:.1}" y="{y:.1}">{text}</text>"#));
    }

    /// A text on a coloured ground.
    pub fn haloed(&mut self, (x, y): (f64, f64), text: &str) {
        self.push(&format!(r#"<text class="level" text-anchor="middle" x="{x:.1}" y="{y:.1}">{text}</text>"#));
    }

    fn line(&mut self, style: &str, from: (f64, f64), to: (f64, f64)) {
        let ((x1, y1), (x2, y2)) = (from, to);
        self.push(&format!(r#"<path d="M{x1:.1} {y1:.1}L{x2:.1} {y2:.1}" {style}/>"#));
    }

    /// Ticks with grid lines and their labels, and what the axes are.
    pub fn axes(&mut self, panel: &Panel, ticks: (&[f64], &[f64]), labels: (&str, &str)) {
        let ((left, top), (width, height)) = (panel.corner, panel.size);
        let (right, bottom) = (left + width, top + height);
        for &tick in ticks.0 {
            let (x, _) = panel.place((tick, panel.y.0));
            self.line(r##"stroke="#d0d7de""##, (x, top), (x, bottom));
            self.text("middle", (x, bottom + 16.0), &number(tick));
        }
        for &tick in ticks.1 {
            let (_, y) = panel.place((panel.x.0, tick));
            self.line(r##"stroke="#d0d7de""##, (left, y), (right, y));
            self.text("end", (left - 6.0, y + 4.0), &number(tick));
        }
        self.push(&format!(
            r##"<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="none" stroke="#57606a"/>"##
        ));
        self.text("middle", (left + 0.5 * width, bottom + 33.0), labels.0);
        let (x, y) = (left - 42.0, top + 0.5 * height);
        self.push(&format!(
            r#"<text text-anchor="middle" transform="translate({x} {y}) rotate(-90)">{}</text>"#,
            labels.1
        ));
    }

    /// Straight lines through points.
    pub fn curve(&mut self, panel: &Panel, style: &str, points: &[(f64, f64)]) {
        let mut path = String::new();
        for (index, point) in points.iter().enumerate() {
            let (x, y) = panel.place(*point);
            path.push_str(&format!("{}{x:.1} {y:.1}", if index == 0 { 'M' } else { 'L' }));
        }
        self.push(&format!(r#"<path d="{path}" fill="none" {style}/>"#));
    }

    /// Colour bands between levels, contours with their values, and the levels beside the panel.
    pub fn map(&mut self, panel: &Panel, grid: &Grid, levels: &[f64]) {
        let ((left, top), (width, height)) = (panel.corner, panel.size);
        self.push(&format!(r#"<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="url(#none)"/>"#));
        let mut contours: Vec<Vec<[(f64, f64); 2]>> = vec![Vec::new(); levels.len()];
        let mut shapes = vec![String::new(); levels.len()];
        let mut run: Option<Run> = None;
        let mut draw = |run: Option<Run>| {
            let Some(Run { band, from: (x, y), to: (right, bottom) }) = run else { return };
            // a little more than the parts, so that no seam shows
            let (w, h) = (right - x + 0.5, bottom - y + 0.5);
            shapes[band].push_str(&format!("M{x:.1} {y:.1}h{w:.1}v{h:.1}h-{w:.1}z"));
        };
        for part in parts(grid) {
            let corners = part.map(|(cell, share)| (panel.place(grid.point(cell, share)), grid.between(cell, share)));
            let mean = 0.25 * corners.iter().map(|corner| corner.1).sum::<f64>();
            // hatched where there is no value, or less than the least level
            if !(mean >= levels[0]) {
                continue;
            }
            let band = levels.iter().skip(1).filter(|level| mean >= **level).count().min(levels.len() - 2);
            let (from, to) = (corners[3].0, corners[1].0);
            run = match run {
                Some(run) if run.band == band && run.to.1 == to.1 && (run.to.0 - from.0).abs() < 1e-6 => {
                    Some(Run { to, ..run })
                }
                other => {
                    draw(other);
                    Some(Run { band, from, to })
                }
            };
            for (level, segments) in levels.iter().zip(&mut contours) {
                segments.extend(crossing(&corners, *level));
            }
        }
        draw(run);
        for (band, shape) in shapes.iter().enumerate().filter(|(_, shape)| !shape.is_empty()) {
            let fill = color(band, levels.len() - 1);
            self.push(&format!(r#"<path d="{shape}" fill="{fill}"/>"#));
        }
        self.contours(panel, levels, &contours);
        self.legend((left + width + 12.0, top), height, levels);
    }

    fn contours(&mut self, panel: &Panel, levels: &[f64], contours: &[Vec<[(f64, f64); 2]>]) {
        let mut labels: Vec<(f64, f64)> = Vec::new();
        let inside = |(x, y): (f64, f64)| {
            let from = (x - panel.corner.0, y - panel.corner.1);
            from.0.min(from.1).min(panel.size.0 - from.0).min(panel.size.1 - from.1)
        };
        let apart = |a: (f64, f64), b: (f64, f64)| f64::hypot(a.0 - b.0, a.1 - b.1);
        let mut texts = Vec::new();
        for (level, segments) in levels.iter().zip(contours) {
            let path: String =
                segments.iter().map(|[a, b]| format!("M{:.1} {:.1}L{:.1} {:.1}", a.0, a.1, b.0, b.1)).collect();
            self.push(&format!(r##"<path d="{path}" stroke="#57606a" stroke-width="0.8" fill="none"/>"##));
            // where there is room: far from the edge and from other labels
            let room = |at: (f64, f64)| labels.iter().map(|other| apart(*other, at)).fold(2.0 * inside(at), f64::min);
            let best = segments.iter().map(|segment| segment[0]).max_by(|a, b| room(*a).total_cmp(&room(*b)));
            if let Some(at) = best.filter(|at| room(*at) > 24.0) {
                labels.push(at);
                texts.push((at, number(*level)));
            }
        }
        for ((x, y), text) in texts {
            self.haloed((x, y + 4.0), &text);
        }
    }

    fn legend(&mut self, (left, top): (f64, f64), height: f64, levels: &[f64]) {
        let bands = levels.len().saturating_sub(1).max(1);
        let step = height / bands as f64;
        for (band, fill) in (0..bands).map(|band| (band, color(band, bands))) {
            let y = top + height - step * (band + 1) as f64;
            self.push(&format!(r#"<rect x="{left}" y="{y:.1}" width="14" height="{:.1}" fill="{fill}"/>"#, step + 0.3));
        }
        for (edge, level) in levels.iter().enumerate() {
            self.text("start", (left + 19.0, top + height - step * edge as f64 + 4.0), &number(*level));
        }
    }

    fn push(&mut self, element: &str) {
        // writing to a string cannot fail
        let _ = writeln!(self.body, "{element}");
    }

    /// The file.
    pub fn finish(self) -> String {
        let Self { body, width, height, title } = self;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" role=\"img\" font-family=\"sans-serif\" \
             font-size=\"12\">\n<title>{title}</title>\n<style>text {{ fill: #1b1f24; }} .level {{ paint-order: stroke; stroke: \
             #ffffff; stroke-width: 3px; }}</style>\n<defs><pattern id=\"none\" width=\"6\" height=\"6\" \
             patternUnits=\"userSpaceOnUse\"><path d=\"M0 6L6 0\" stroke=\"#d0d7de\"/></pattern></defs>\n<rect \
             width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n{body}</svg>\n"
        )
    }
}

/// Colour of a band of so many: light for small and dark for large, as in the figures of reports.
fn color(band: usize, count: usize) -> String {
    colour::at(band as f64 / count.saturating_sub(1).max(1) as f64)
}

/// A place in a cell of a grid, by shares.
type Place = ((usize, usize), (f64, f64));

/// The corners of every part of every cell, anticlockwise from where x and y are least; along x first, through all cells.
fn parts(grid: &Grid) -> impl Iterator<Item = [Place; 4]> {
    let (columns, rows) = (FINENESS * (grid.x.len() - 1), FINENESS * (grid.y.len() - 1));
    let share = |k: usize| k as f64 / FINENESS as f64;
    (0..rows).flat_map(move |row| {
        (0..columns).map(move |column| {
            let cell = (column / FINENESS, row / FINENESS);
            let (k, l) = (column % FINENESS, row % FINENESS);
            [(k, l), (k + 1, l), (k + 1, l + 1), (k, l + 1)].map(|(k, l)| (cell, (share(k), share(l))))
        })
    })
}

/// Where a level crosses the edges of a part.
fn crossing(corners: &[((f64, f64), f64); 4], level: f64) -> Option<[(f64, f64); 2]> {
    let mut points = (0..4).filter_map(|k| {
        let ((a, low), (b, high)) = (corners[k], corners[(k + 1) % 4]);
        if (low < level) == (high < level) {
            return None;
        }
        let share = (level - low) / (high - low);
        Some((a.0 + share * (b.0 - a.0), a.1 + share * (b.1 - a.1)))
    });
    Some([points.next()?, points.next()?])
}

/// A number without the rounding of its sum.
fn number(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').replace('-', "−")
}
