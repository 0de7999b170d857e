package nephele.engine.sim;

import java.util.Locale;
import nephele.engine.level.RecordFile;
import nephele.engine.level.Written;
import nephele.engine.math.Vec3;

/** A state for people and scripts to look at: what {@code simulate --dump} writes. */
public record StateDump(
        @Written(required = true) long tick,
        @Written(required = true) String hash,
        @Written(required = true) Vec3 feet,
        @Written(required = true) Vec3 velocity,
        @Written(required = true) double yawDegrees,
        @Written(required = true) double pitchDegrees,
        @Written(required = true) double eyeMetres,
        @Written(required = true) PlayerBody.Stance stance,
        @Written Vec3 ground,
        @Written(required = true) int faults) {
    private static final RecordFile<StateDump> FILE = RecordFile.of("state", 1, StateDump.class);

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
                state.faults());
    }

    /** The file's text. */
    public String write() {
        return FILE.write(this);
    }
}
