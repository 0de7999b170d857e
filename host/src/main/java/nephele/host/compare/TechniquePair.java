package nephele.host.compare;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.WeatherClouds;

/**
 * Two techniques to be compared.
 *
 * @param left shown left of the wipe
 * @param right shown right of it
 */
public record TechniquePair(CloudTechnique left, CloudTechnique right) {
    /**
     * Reads {@code A,B}.
     *
     * @throws IllegalArgumentException with all names if the text is not two of them
     */
    public static TechniquePair parse(String text) {
        String[] words = text.split(",", -1);
        if (words.length != 2) {
            throw new IllegalArgumentException(
                    "'" + text + "' is not two techniques A,B of " + names() + ", such as particles,volume");
        }
        return new TechniquePair(technique(words[0]), technique(words[1]));
    }

    /**
     * Reads the name of one technique, as files have it, ignoring case.
     *
     * @throws IllegalArgumentException with all names for another text
     */
    public static CloudTechnique technique(String word) {
        return Arrays.stream(CloudTechnique.values())
                .filter(technique -> technique.name().equalsIgnoreCase(word.trim()))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("'" + word.trim() + "' is none of " + names()));
    }

    private static String names() {
        return Arrays.stream(CloudTechnique.values()).map(TechniquePair::name).collect(Collectors.joining(", "));
    }

    /** Returns the name of a technique, as files have it. */
    public static String name(CloudTechnique technique) {
        return technique.name().toLowerCase(Locale.ROOT);
    }

    /** Returns the technique that the other one is compared with: the volume, which is nearest to exact, else the left one. */
    public CloudTechnique reference() {
        return isReferenceLeft() ? left : right;
    }

    /** Returns the technique whose difference from {@link #reference} is measured. */
    public CloudTechnique tried() {
        return isReferenceLeft() ? right : left;
    }

    boolean isReferenceLeft() {
        return left == CloudTechnique.VOLUME || right != CloudTechnique.VOLUME;
    }

    /** Returns a level whose clouds are all drawn by a technique. */
    public static Level drawnBy(Level level, CloudTechnique technique) {
        return level.with(WeatherClouds.drawnBy(level.environment(), technique), level.lights());
    }

    /** Returns the reason why techniques cannot be compared in a level; empty if they can. */
    public static Optional<String> obstacle(Level level) {
        Environment environment = level.environment();
        if (WeatherClouds.all(environment).isEmpty()) {
            return Optional.of("there is no cloud in this level whose techniques could be compared");
        }
        boolean isOnlyChanging = environment.clouds().isEmpty()
                && !environment.weatherKeyframes().isEmpty();
        return isOnlyChanging
                ? Optional.of("clouds of weatherKeyframes keep their technique: there is nothing to compare")
                : Optional.empty();
    }
}
