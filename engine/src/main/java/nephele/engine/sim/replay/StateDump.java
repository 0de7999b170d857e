package nephele.engine.sim.replay;

import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.level.Range;
import nephele.engine.level.Written;
import nephele.engine.level.json.RecordFile;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.WorldState.HeldBody;

/** A state in a form for people and scripts: the output of {@code simulate --dump}. */
public record StateDump(
        @Written(required = true) @Range long tick,
        @Written(required = true) String hash,
        @Written(required = true) @Range Vec3 feet,
        @Written(required = true) @Range Vec3 velocity,
        @Written(required = true) @Range double yawDegrees,
        @Written(required = true) @Range double pitchDegrees,
        @Written(required = true) @Range double eyeMetres,
        @Written(required = true) PlayerDimensions.Stance stance,
        @Written @Range Vec3 ground,
        @Written(required = true) @Range int faults,
        @Written(most = 100_000) List<DumpedBody> bodies,
        @Written(most = 1000) List<DumpedPortal> portals,
        @Written DumpedHolding holding) {
    private static final RecordFile<StateDump> FILE = RecordFile.of("state", 1, StateDump.class);

    /** The motion of a body; the orientation is the vector part of a quaternion with non-negative scalar part. */
    public record DumpedBody(
            @Written(required = true) @Range Vec3 centre,
            @Written(required = true) @Range Vec3 orientation,
            @Written(required = true) @Range Vec3 velocity,
            @Written(required = true) @Range Vec3 spin,
            @Written boolean asleep) {
        static DumpedBody of(Bodies bodies, int body) {
            BodyState state = bodies.state(body);
            var q = state.orientation();
            double sign = q.w < 0 ? -1 : 1;
            Vec3 vector = new Vec3(sign * q.x, sign * q.y, sign * q.z);
            return new DumpedBody(state.centre(), vector, state.velocity(), state.spin(), bodies.isAsleep(body));
        }
    }

    /** The place of a portal, and the index of its partner, −1 for none. */
    public record DumpedPortal(
            @Written(required = true) String id,
            @Written(required = true) @Range Vec3 centre,
            @Written(required = true) @Range Vec3 normal,
            @Written(required = true) @Range Vec3 up,
            @Written(required = true) @Range int leadsTo) {
        static DumpedPortal of(Portals portals, int index) {
            Portal portal = portals.portal(index);
            return new DumpedPortal(
                    portal.id(),
                    portal.centre(),
                    portal.normal(),
                    portal.frame().up(),
                    portals.partner(index));
        }
    }

    /** The held body, and the ids of the portals on the line to it. */
    public record DumpedHolding(
            @Written(required = true) @Range int body,
            @Written(most = 1000) List<String> through,
            @Written @Range int ticksUnseen) {
        static DumpedHolding of(HeldBody held, Portals portals) {
            List<String> through = IntStream.range(0, held.word().length())
                    .mapToObj(i -> portals.portal(held.word().entry(i)).id())
                    .toList();
            return held.isHolding() ? new DumpedHolding(held.body(), through, held.ticksUnseen()) : null;
        }
    }

    /** Returns the dump of a state. */
    public static StateDump of(SimState state) {
        PlayerState player = state.player();
        return new StateDump(
                state.tick(),
                String.format(Locale.ROOT, "%016x", state.hash()),
                player.feet(),
                player.velocity(),
                player.heading().yawMillidegrees() / 1000.0,
                player.heading().pitchMillidegrees() / 1000.0,
                player.eyeMetres(),
                player.stance(),
                player.ground(),
                state.faults(),
                IntStream.range(0, state.world().bodies().size())
                        .mapToObj(i -> DumpedBody.of(state.world().bodies(), i))
                        .toList(),
                IntStream.range(0, state.world().portals().size())
                        .mapToObj(i -> DumpedPortal.of(state.world().portals(), i))
                        .toList(),
                DumpedHolding.of(state.world().holding(), state.world().portals()));
    }

    /** Returns the file's text. */
    public String write() {
        return FILE.write(this);
    }
}
