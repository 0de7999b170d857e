package nephele.host.userfile;

import com.google.gson.GsonBuilder;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import com.google.gson.Strictness;
import com.google.gson.stream.JsonReader;
import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.TextFile;

/**
 * A JSON file with the head {@code {"format": …, "version": …}} that belongs to the user. Reading never fails: of a
 * damaged file the backup is used, or nothing, and the damaged bytes are kept as {@code .broken} before the file is
 * first replaced. Saving is atomic, and the version before stays as {@code .bak}.
 */
public final class UserFile {
    /** Greatest number of different damaged files that are kept; the last one is replaced. */
    private static final int MOST_BROKEN = 20;

    private static final int LARGEST_BYTES = 1 << 20;

    private final Path path;
    private final String format;
    private final int version;

    /**
     * Names a file.
     *
     * @param path {@code null} if there is no place for it: nothing is then read or saved
     * @param format the value of its member {@code format}
     */
    public UserFile(Path path, String format, int version) {
        this.path = path;
        this.format = format;
        this.version = version;
    }

    /** Returns the file's path; {@code null} if there is none. */
    public Path path() {
        return path;
    }

    /**
     * Returns all members of the file; empty if there is no usable one.
     *
     * @param report receives a line for each problem, which names the file
     */
    public JsonObject read(Consumer<String> report) {
        if (path == null) {
            return new JsonObject();
        }
        try {
            return parsed(path);
        } catch (Unusable problem) {
            Path backup = beside(".bak");
            if (problem.isMissing && !Files.exists(backup)) {
                return new JsonObject();
            }
            try {
                JsonObject kept = parsed(backup);
                report.accept(path + ": " + problem.getMessage() + "; its backup " + backup.getFileName() + " is used");
                return kept;
            } catch (Unusable neither) {
                report.accept(path + ": " + problem.getMessage() + "; it is kept as " + nameToReport()
                        + " when a new one is saved");
                return new JsonObject();
            }
        }
    }

    /**
     * Replaces the file by these members and the head.
     *
     * @throws IOException with a message for users that names the file and the reason; the file is then unchanged
     */
    public void save(JsonObject members) throws IOException {
        if (path == null) {
            return;
        }
        keepOld();
        JsonObject whole = new JsonObject();
        whole.addProperty("format", format);
        whole.addProperty("version", version);
        members.entrySet().forEach(member -> {
            if (!whole.has(member.getKey())) {
                whole.add(member.getKey(), member.getValue());
            }
        });
        String text = new GsonBuilder()
                .setPrettyPrinting()
                .disableHtmlEscaping()
                .serializeNulls()
                .create()
                .toJson(whole);
        AtomicFile.write(path, (text + "\n").getBytes(StandardCharsets.UTF_8));
    }

    /** Keeps a good file as backup, and a damaged one beside it. */
    private void keepOld() throws IOException {
        if (!Files.isRegularFile(path)) {
            return;
        }
        try {
            parsed(path);
            AtomicFile.copy(path, beside(".bak"));
        } catch (Unusable damaged) {
            AtomicFile.copy(path, brokenName());
        }
    }

    private Path nameToReport() {
        try {
            return brokenName().getFileName();
        } catch (IOException unreadable) {
            return beside(".broken").getFileName();
        }
    }

    /** Returns the name under which the damaged file is kept: one that no other damaged file has. */
    private Path brokenName() throws IOException {
        for (int number = 1; number < MOST_BROKEN; number++) {
            Path name = beside(number == 1 ? ".broken" : ".broken-" + number);
            if (!Files.exists(name) || Files.mismatch(name, path) == -1) {
                return name;
            }
        }
        return beside(".broken-" + MOST_BROKEN);
    }

    private Path beside(String suffix) {
        return path.resolveSibling(path.getFileName() + suffix);
    }

    private JsonObject parsed(Path file) {
        JsonElement root = parsedText(text(file));
        if (!root.isJsonObject()) {
            throw new Unusable("it is no JSON object");
        }
        JsonObject members = root.getAsJsonObject();
        if (!new JsonPrimitive(format).equals(members.get("format"))) {
            throw new Unusable("it does not say \"format\": \"" + format + "\"");
        }
        if (!new JsonPrimitive(version).equals(members.get("version"))) {
            throw new Unusable("it does not say \"version\": " + version);
        }
        members.remove("format");
        members.remove("version");
        return members;
    }

    private static JsonElement parsedText(String text) {
        try {
            JsonReader reader = new JsonReader(new StringReader(text));
            reader.setStrictness(Strictness.STRICT);
            JsonElement root = JsonParser.parseReader(reader);
            if (reader.peek() != com.google.gson.stream.JsonToken.END_DOCUMENT) {
                throw new Unusable("it has more than one JSON value");
            }
            return root;
        } catch (JsonParseException | IOException | NumberFormatException | StackOverflowError noJson) {
            throw new Unusable("it is no JSON");
        }
    }

    private static String text(Path file) {
        if (!Files.exists(file)) {
            throw new Unusable();
        }
        try {
            byte[] bytes = AtomicFile.read(file, LARGEST_BYTES);
            if (bytes.length > LARGEST_BYTES) {
                throw new Unusable("it is larger than " + (LARGEST_BYTES >> 20) + " MiB");
            }
            return TextFile.text(bytes);
        } catch (IOException unreadable) {
            throw new Unusable("it can't be read: " + AtomicFile.reason(unreadable));
        }
    }

    /** The reason why a file is not used. */
    private static final class Unusable extends RuntimeException {
        private static final long serialVersionUID = 1;

        private final transient boolean isMissing;

        private Unusable() {
            super("it is missing");
            isMissing = true;
        }

        private Unusable(String message) {
            super(message);
            isMissing = false;
        }
    }
}
