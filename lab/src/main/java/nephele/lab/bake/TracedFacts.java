package nephele.lab.bake;

import java.util.Map;
import nephele.engine.reference.Pinhole;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.host.named.OpenedLevel;

/** Names what a traced picture depends on, for the heads of its parts. */
public final class TracedFacts {
    private TracedFacts() {}

    /**
     * Returns the facts by name.
     *
     * @param seconds simulated time
     * @param kind what the values of the picture are
     */
    public static Map<String, String> of(
            OpenedLevel opened, double seconds, Pinhole eye, TraceSettings settings, String kind) {
        return Map.of(
                "level", LevelHash.key(opened),
                "seconds", Double.toString(seconds),
                "camera", eye.toString(),
                "samples", Integer.toString(settings.samples()),
                "seed", Long.toString(settings.seed()),
                "colours", kind,
                "tracer", Integer.toString(ReferencePicture.VERSION));
    }
}
