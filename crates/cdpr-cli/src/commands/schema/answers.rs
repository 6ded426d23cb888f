//! Schema of the answers of all subcommands.

use cdpr_reports::AnswerSchemas;
use cdpr_reports::answers::{
    AccuracyAnswer, AdviceAnswer, BenchmarkAnswer, CampaignAnswer, CapabilityAnswer, ChainAnswer, CheckAnswer,
    CompensationAnswer, DynamicsAnswer, EffectsAnswer, EvaluationAnswer, ExportAnswer, FirmwareAnswer, ForwardAnswer,
    FrequencyResponseAnswer, FrictionAnswer, IdentificationAnswer, ImportAnswer, InitialTensionAnswer, InverseAnswer,
    LoadAnswer, ModesAnswer, NoHangingAnswer, PlanAnswer, RobotsAnswer, RunAnswer, SelectionAnswer,
    SelfCalibrationAnswer, SimulationAnswer, StiffnessAnswer, StudyAnswer, TableAnswer, TensionAnswer, TestBenchAnswer,
    WorkspaceAnswer,
};
use cdpr_reports::cost_result::CostResult;
use cdpr_reports::reachable::ReachableAnswer;
use cdpr_reports::sensitivity::SensitivityAnswer;
use cdpr_reports::sweep_progress::SweepProgress;
use cdpr_reports::sweep_result::SweepResult;
use schemars::Schema;

use crate::commands::{completions, explain, man, new, place_pulleys, robots};
use crate::failure::FailureObject;

/// One definition per answer, and the subcommands with theirs; `error` is what any of them says instead of an answer.
pub(super) fn schema() -> Schema {
    AnswerSchemas::default()
        .with::<RobotsAnswer>("robots")
        .with::<robots::RobotFile>("robots")
        .with::<new::Written>("new")
        .with::<new::Offer>("new")
        .with::<CheckAnswer>("check")
        .with::<place_pulleys::Placed>("place-pulleys")
        .with::<ImportAnswer>("import")
        .with::<InverseAnswer>("ik")
        .with::<NoHangingAnswer>("ik")
        .with::<ForwardAnswer>("fk")
        .with::<TensionAnswer>("tension")
        .with::<LoadAnswer>("load")
        .with::<StiffnessAnswer>("stiffness")
        .with::<DynamicsAnswer>("dynamics")
        .with::<ModesAnswer>("modes")
        .with::<EffectsAnswer>("model")
        .with::<WorkspaceAnswer>("workspace")
        .with::<CapabilityAnswer>("capability")
        .with::<ReachableAnswer>("reachable")
        .with::<SweepProgress>("sweep")
        .with::<SweepResult>("sweep")
        .with::<CostResult>("sweep")
        .with::<AdviceAnswer>("advise")
        .with::<AccuracyAnswer>("accuracy")
        .with::<StudyAnswer>("study")
        .with::<SensitivityAnswer>("sensitivity")
        .with::<InitialTensionAnswer>("initial-tension")
        .with::<BenchmarkAnswer>("benchmark")
        .with::<ChainAnswer>("chain")
        .with::<SelectionAnswer<'static>>("demo")
        .with::<PlanAnswer>("plan")
        .with::<SimulationAnswer>("simulate")
        .with::<IdentificationAnswer>("identify")
        .with::<SelfCalibrationAnswer>("identify")
        .with::<SelectionAnswer<'static>>("select")
        .with::<EvaluationAnswer>("evaluate")
        .with::<CompensationAnswer>("compensate")
        .with::<CampaignAnswer>("campaign")
        .with::<TestBenchAnswer>("test-bench")
        .with::<FrequencyResponseAnswer>("frequency-response")
        .with::<FrictionAnswer>("friction")
        .with::<RunAnswer>("run")
        .with::<ExportAnswer>("export")
        .with::<FirmwareAnswer>("export")
        .with::<TableAnswer>("export")
        .with::<explain::Explained>("explain")
        .with::<explain::Listed>("explain")
        .with::<completions::Completions>("completions")
        .with::<man::Written>("man")
        .with::<FailureObject<'static>>("error")
        .schema()
}
