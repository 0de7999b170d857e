package nephele.mutants;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A planted fault.
 *
 * @param file a Java source or shader, relative to the repository
 * @param text the replaced text, which occurs in the file exactly once
 * @param killer the test class that must fail, by its simple name, with folders before it if the name is not unique
 */
record Mutant(Area area, String name, String file, String text, String replacement, String killer) {
    enum Area {
        CULLING,
        DEPTH,
        BLENDING,
        SHADOW,
        SRGB,
        LIGHT,
        COLLISION,
        PLACEMENT,
        SIMULATION,
        LEVEL,
        MODEL,
        CLOUD,
        SKY,
        PARTICLE,
        TERRAIN,
        PLANT
    }

    /** Returns the file's text with the fault. */
    String mutated() throws IOException {
        String source = Files.readString(Path.of(file));
        int at = source.indexOf(text);
        if (at < 0 || source.indexOf(text, at + 1) >= 0) {
            String found = at < 0 ? "not" : "more than once";
            throw new IOException(name + ": `" + text + "` stands " + found + " in " + file + "; adapt the mutant");
        }
        if (replacement.equals(text)) {
            throw new IOException(name + ": nothing is replaced");
        }
        return source.substring(0, at) + replacement + source.substring(at + text.length());
    }

    boolean isJava() {
        return file.endsWith(".java");
    }

    /** Returns the file's place on a class path. */
    String resource() {
        return file.substring(file.indexOf("/nephele/") + 1);
    }
}
