package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.portal.PortalCrossing;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The player's way through a portal: the student report's teleport against the time of impact. */
public final class TraversalSubject implements Experiment {
    static final int TICKS_PER_RUN = 20_000;
    private static final int WALKS = 100;
    private static final double TICK_SECONDS = 1.0 / 120;
    private static final Vector3dc STRAIGHT = new Vector3d();

    public static final Trade TRADE = new Trade(
            "traversal",
            new Trade.Text(
                    "Going through a portal",
                    "The source moves whoever is near to the middle before the other portal and makes them look along"
                        + " its normal. The game finds the instant at which the body's centre enters, and turns"
                        + " everything by the portals' rigid map. Leaps are in pixels of a 1280×720 picture, points"
                        + " that leave it counting as its diagonal; cost is that of looking for portals in a tick of"
                        + " walking.",
                    "a window: what is seen does not leap at all"),
            List.of(),
            List.of(
                    new Setting("teleport", "the source's way, within " + ViewPose.NEAR_METRES + " m"),
                    new Setting("teleportKeepingView", "the same, but the view keeps its angle to the portal"),
                    new Setting("timeOfImpact", "the game's")),
            2,
            new ErrorMetric("mean leap of picture points", "px", 0.01, 0.5),
            List.of("median turn of the view, °", "worst turn, °", "leap of the eye, m"),
            new CostMetric("CPU a tick", "ns", 1, TICKS_PER_RUN, CostMetric.Clock.THREAD),
            null,
            site -> new TraversalSubject());

    private final List<RecordedTraversal> walks = new ArrayList<>();
    private final List<Vec3> places = new ArrayList<>();
    private final List<Vector3d> centres = new ArrayList<>();
    private final List<Vector3d> velocities = new ArrayList<>();
    private final PortalCrossing crossing = new PortalCrossing();
    /** Uses the result, so that the compiler cannot eliminate the timed code. */
    private int found;

    private TraversalSubject() {
        for (int seed = 0; seed < WALKS; seed++) {
            var walk = new RecordedTraversal(seed);
            walks.add(walk);
            walk.states().forEach(state -> {
                places.add(state.player().eye());
                centres.add(state.player().centre().toVector());
                velocities.add(state.player().velocity().toVector());
            });
        }
    }

    @Override
    public Judgement judge(int setting) {
        List<ViewJump> jumps = new ArrayList<>();
        for (RecordedTraversal walk : walks) {
            ViewJump jump = jump(setting, walk);
            if (jump != null) {
                jumps.add(jump);
            }
        }
        jumps.sort(Comparator.comparingDouble(ViewJump::degrees));
        return Judgement.of(
                jumps.stream().mapToDouble(ViewJump::pixels).average().orElseThrow(),
                jumps.get(jumps.size() / 2).degrees(),
                jumps.get(jumps.size() - 1).degrees(),
                jumps.stream().mapToDouble(ViewJump::metres).average().orElseThrow());
    }

    private static ViewJump jump(int setting, RecordedTraversal walk) {
        Portals portals = walk.portals();
        PortalTransform transform = portals.transform(0);
        if (setting == 2) {
            ViewPose[] through = walk.through();
            return through == null ? null : ViewJump.of(transform, through[0], through[1]);
        }
        ViewPose near = walk.near();
        if (near == null) {
            return null;
        }
        ViewPose moved = setting == 0
                ? ViewPose.alongNormal(portals.portal(1))
                : ViewPose.keepingView(transform, portals.portal(1), near);
        return ViewJump.of(transform, near, moved);
    }

    @Override
    public void run(int setting) {
        Portals portals = walks.get(0).portals();
        for (int tick = 0; tick < TICKS_PER_RUN; tick++) {
            int at = tick % places.size();
            found += (setting == 2 ? isEntering(portals, at) : isNear(portals, at)) ? 1 : 0;
        }
    }

    private boolean isEntering(Portals portals, int at) {
        return crossing.find(portals, centres.get(at), velocities.get(at), STRAIGHT, TICK_SECONDS);
    }

    private boolean isNear(Portals portals, int at) {
        for (int portal = 0; portal < portals.size(); portal++) {
            if (ViewPose.isDue(portals.portal(portal), places.get(at))) {
                return true;
            }
        }
        return false;
    }
}
