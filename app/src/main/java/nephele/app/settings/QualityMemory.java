package nephele.app.settings;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import nephele.engine.asset.TextFile;

/**
 * The frame times of levels on the machines that drew them, from which automatic quality chooses its first frame; immutable. A
 * broken entry counts as unknown, and is replaced when its level is played.
 */
public final class QualityMemory {
    private static final String MACHINES = "machines";
    private static final String HIGH_NANOS_PER_PIXEL = "highNanosPerPixel";

    /** Greatest number of machines, and of levels of one: the ones that were learned first are forgotten. */
    private static final int MOST_ENTRIES = 200;

    private final JsonObject members;

    /** @param members of the file */
    public QualityMemory(JsonObject members) {
        this.members = members.deepCopy();
    }

    /**
     * Returns what a frame of a level usually costs at quality high, ms; empty if it was not drawn on this machine.
     *
     * @param machine with its renderer
     * @param pixels of the picture
     */
    public OptionalDouble highMillis(String machine, String level, long pixels) {
        return object(object(members, MACHINES), machine).get(level) instanceof JsonObject entry
                        && entry.get(HIGH_NANOS_PER_PIXEL) instanceof JsonPrimitive nanos
                        && nanos.isNumber()
                        && nanos.getAsDouble() > 0
                        && nanos.getAsDouble() < 1e9
                ? OptionalDouble.of(nanos.getAsDouble() * pixels / 1e6)
                : OptionalDouble.empty();
    }

    /** Returns this memory with what a level has cost. */
    public QualityMemory with(String machine, String level, long pixels, double highMillis) {
        JsonObject entry = new JsonObject();
        entry.addProperty(HIGH_NANOS_PER_PIXEL, Math.rint(10 * highMillis * 1e6 / pixels) / 10);
        JsonObject machines = object(members, MACHINES);
        JsonObject all = members.deepCopy();
        all.add(MACHINES, newest(machines, machine, newest(object(machines, machine), level, entry)));
        return new QualityMemory(all);
    }

    /** Returns this machine's name: the processor's model, the number of its cores, the OpenGL renderer. */
    public static String machine(String renderer) {
        String model = listedProcessor()
                .or(() -> Optional.ofNullable(System.getenv("PROCESSOR_IDENTIFIER")))
                .orElse(System.getProperty("os.arch"));
        return model + " × " + Runtime.getRuntime().availableProcessors() + ", " + renderer;
    }

    private static Optional<String> listedProcessor() {
        try {
            return TextFile.lines(Path.of("/proc/cpuinfo")).stream()
                    .filter(line -> line.startsWith("model name"))
                    .findFirst()
                    .map(line -> line.substring(line.indexOf(':') + 1).strip());
        } catch (IOException notLinux) {
            return Optional.empty();
        }
    }

    private static JsonObject object(JsonObject of, String name) {
        return of.get(name) instanceof JsonObject there ? there : new JsonObject();
    }

    /** Returns the entries with another one at their end, without the first ones if they are too many. */
    private static JsonObject newest(JsonObject entries, String name, JsonElement value) {
        JsonObject changed = entries.deepCopy();
        changed.remove(name);
        changed.add(name, value);
        while (changed.size() > MOST_ENTRIES) {
            changed.remove(changed.keySet().iterator().next());
        }
        return changed;
    }

    /** Returns the members of the file. */
    public JsonObject members() {
        return members.deepCopy();
    }
}
