package nephele.lab.technique;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import nephele.engine.level.CloudTechnique;

/**
 * The words and figures of a technique's page, from the file with its name beside this class: lines of a key, a colon and a
 * value, which may be HTML. A key that stands more than once has a list of values.
 */
final class TechniqueText {
    /** The techniques of pages and table, from the farthest clouds to the nearest. */
    static final List<CloudTechnique> ALL = List.of(
            CloudTechnique.SKYBOX,
            CloudTechnique.SKYPLANE,
            CloudTechnique.PROCEDURAL,
            CloudTechnique.BILLBOARD,
            CloudTechnique.PARTICLES,
            CloudTechnique.VOLUME);

    /** The purposes for which a technique can be suited. */
    static final List<String> PURPOSES = List.of("distant", "prominent", "near", "crossable");

    private final CloudTechnique technique;
    private final Map<String, List<String>> values = new LinkedHashMap<>();

    private TechniqueText(CloudTechnique technique, String text) {
        this.technique = technique;
        for (String line : text.lines().filter(one -> !one.isBlank()).toList()) {
            int colon = line.indexOf(": ");
            if (colon < 0) {
                throw new IllegalArgumentException(file(technique) + ": no key in: " + line);
            }
            values.computeIfAbsent(line.substring(0, colon), key -> new ArrayList<>())
                    .add(line.substring(colon + 2));
        }
    }

    static TechniqueText of(CloudTechnique technique) {
        return new TechniqueText(technique, resource(file(technique)));
    }

    private static String file(CloudTechnique technique) {
        return word(technique) + ".txt";
    }

    /** Returns a text file that lies beside this class. */
    static String resource(String name) {
        try (var stream = TechniqueText.class.getResourceAsStream(name)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }

    static String word(CloudTechnique technique) {
        return technique.name().toLowerCase(Locale.ROOT);
    }

    CloudTechnique technique() {
        return technique;
    }

    /** Returns the one value of a key. */
    String one(String key) {
        List<String> found = all(key);
        if (found.size() != 1) {
            throw new IllegalArgumentException(file(technique) + ": one line must begin with " + key + ":");
        }
        return found.get(0);
    }

    /** Returns the values of a key in their order; none if it has none. */
    List<String> all(String key) {
        return values.getOrDefault(key, List.of());
    }

    boolean isSuited(String purpose) {
        return List.of(one("suited").split(", ")).contains(purpose);
    }

    /**
     * A shortcoming.
     *
     * @param wrong the picture of it
     * @param right the same view as it should be
     */
    record Failure(String caption, PictureCommand wrong, PictureCommand right) {}

    /** Returns the shortcomings that the page shows. */
    List<Failure> failures() {
        List<Failure> failures = new ArrayList<>();
        List<String> wrong = all("wrong");
        List<String> right = all("right");
        for (int i = 0; i < all("failure").size(); i++) {
            failures.add(new Failure(
                    all("failure").get(i), PictureCommand.of(wrong.get(i)), PictureCommand.of(right.get(i))));
        }
        return failures;
    }
}
