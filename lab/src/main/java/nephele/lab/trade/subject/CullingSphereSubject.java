package nephele.lab.trade.subject;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;
import nephele.lab.trade.subject.ReportCulling.Fault;

/** The scene-engine report's culling spheres, with its three errors and with each of them alone, against exact ones. */
public final class CullingSphereSubject {
    /** Of the settings before the last one. */
    static final List<Set<Fault>> FAULTS = List.of(
            EnumSet.allOf(Fault.class),
            EnumSet.of(Fault.LARGEST_COORDINATE),
            EnumSet.of(Fault.LAST_ROTATION),
            EnumSet.of(Fault.LEFT_POINT));

    public static final Trade TRADE = new Trade(
            "cullingSpheres",
            new Trade.Text(
                    "A sphere around each model",
                    "What is outside of the view is found by a sphere around each model of an XML scene: 2 000 models"
                            + " in nested groups that are moved, turned and scaled unevenly, some of them moving. The"
                            + " scene-engine report makes three mistakes, here together and one at a time. What is left"
                            + " out though it is in view is missing in the picture.",
                    "each triangle cut by the planes of the view"),
            List.of(),
            List.of(
                    new Setting("report", "all three mistakes"),
                    new Setting("largestCoordinate", "radius: the largest coordinate; a cube's corner is 73 % farther"),
                    new Setting("lastRotation", "a group's rotation replaces those around it"),
                    new Setting("leftPoint", "the right plane goes through the left plane's point"),
                    new Setting("exact", "the viewer's: follows every step exactly")),
            FAULTS.size(),
            new ErrorMetric("left out though in view", "%", 0.01, 0.01),
            List.of("kept though out of view, %", "models left out wrongly, a view"),
            new CostMetric("CPU a frame", "ms", 1e6, CullingSphereExperiment.VIEWS, CostMetric.Clock.THREAD),
            site -> new CullingSphereExperiment());

    private CullingSphereSubject() {}
}
