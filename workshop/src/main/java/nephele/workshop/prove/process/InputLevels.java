package nephele.workshop.prove.process;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import nephele.engine.level.json.LevelJson;

/**
 * Levels that together have every number of the format, and odd versions of them: first each number alone with each odd
 * value, then random pairs.
 */
final class InputLevels {
    private static final List<String> NAMES = List.of("room", "skybox", "air", "ground", "weather", "clouds");
    /** Times at which levels are drawn: the start, amid their changes, and the end of the environment's clock. */
    private static final List<Double> SECONDS = List.of(0.0, 12.5, 1e9);

    private static final int COLOUR_TEXELS = 4;
    private static final int HEIGHT_SAMPLES = 17;

    private final List<LevelNumbers> levels =
            NAMES.stream().map(InputLevels::numbers).toList();
    private final List<OddNumber> alone = new ArrayList<>();

    /** A number that replaces one of a level. */
    private record OddNumber(int level, int place, String number) {}

    /**
     * A level's text with odd numbers.
     *
     * @param numbers the replaced places with their numbers
     * @param seconds the time of the environment at which it is drawn
     */
    record OddInput(String name, byte[] utf8, Map<LevelNumbers.Place, String> numbers, double seconds) {
        /** Returns what is odd in it, to find it again. */
        String reported() {
            return name + " with "
                    + numbers.entrySet().stream()
                            .map(entry -> entry.getKey().path() + " " + entry.getValue())
                            .collect(Collectors.joining(" and "))
                    + " at " + seconds + " s";
        }

        /** Returns true if each number may be where it is. */
        boolean isInRange() {
            return numbers.entrySet().stream()
                    .allMatch(entry -> entry.getKey().permits(Double.parseDouble(entry.getValue())));
        }
    }

    InputLevels() {
        for (int level = 0; level < levels.size(); level++) {
            List<LevelNumbers.Place> places = levels.get(level).places();
            for (int place = 0; place < places.size(); place++) {
                for (String number : places.get(place).oddNumbers()) {
                    alone.add(new OddNumber(level, place, number));
                }
            }
        }
    }

    List<LevelNumbers> levels() {
        return levels;
    }

    /** Returns how many units have one odd number; those after them have two. */
    int numbersAlone() {
        return alone.size();
    }

    /** Returns the level of a unit of the proof. */
    OddInput of(long unit) {
        if (unit < alone.size()) {
            OddNumber odd = alone.get((int) unit);
            return with(odd.level(), Map.of(odd.place(), odd.number()), seconds(unit));
        }
        SplittableRandom random = new SplittableRandom(unit);
        int level = alone.get(random.nextInt(alone.size())).level();
        Map<Integer, String> numbers = new TreeMap<>();
        for (int i = 0; i < 2; i++) {
            int place = random.nextInt(levels.get(level).places().size());
            List<String> odd = List.copyOf(levels.get(level).places().get(place).oddNumbers());
            numbers.put(place, odd.get(random.nextInt(odd.size())));
        }
        return with(level, numbers, seconds(unit));
    }

    private static double seconds(long unit) {
        return SECONDS.get((int) (unit % SECONDS.size()));
    }

    private OddInput with(int level, Map<Integer, String> numbers, double seconds) {
        LevelNumbers all = levels.get(level);
        byte[] utf8 = all.with(numbers).getBytes(StandardCharsets.UTF_8);
        Map<LevelNumbers.Place, String> named = new LinkedHashMap<>();
        numbers.forEach((place, number) -> named.put(all.places().get(place), number));
        return new OddInput(NAMES.get(level), utf8, named, seconds);
    }

    private static LevelNumbers numbers(String name) {
        String file = name + ".json";
        try (InputStream text = InputLevels.class.getResourceAsStream(file)) {
            return new LevelNumbers(LevelJson.read(file, text.readAllBytes()));
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    /** Writes the pictures that the levels name into a folder. */
    static void writePictures(Path folder) throws IOException {
        BufferedImage colour = new BufferedImage(COLOUR_TEXELS, COLOUR_TEXELS, BufferedImage.TYPE_INT_RGB);
        BufferedImage heights = new BufferedImage(HEIGHT_SAMPLES, HEIGHT_SAMPLES, BufferedImage.TYPE_USHORT_GRAY);
        SplittableRandom random = new SplittableRandom(1);
        for (int y = 0; y < HEIGHT_SAMPLES; y++) {
            for (int x = 0; x < HEIGHT_SAMPLES; x++) {
                heights.getRaster().setSample(x, y, 0, random.nextInt(1 << 16));
                colour.setRGB(x % COLOUR_TEXELS, y % COLOUR_TEXELS, random.nextInt(1 << 24));
            }
        }
        write(colour, folder.resolve("colour.png"));
        write(heights, folder.resolve("heights.png"));
    }

    private static void write(BufferedImage picture, Path file) throws IOException {
        try (var out = Files.newOutputStream(file)) {
            ImageIO.write(picture, "png", out);
        }
    }
}
