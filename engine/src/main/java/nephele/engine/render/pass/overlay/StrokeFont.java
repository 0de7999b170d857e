package nephele.engine.render.pass.overlay;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The letters of {@code strokes.txt}, which documents their notation. */
final class StrokeFont {
    /** Width of the pen and the free space between the pens of two letters, in hundredths of an em. */
    static final double PEN_HUNDREDTHS = 8.5;

    static final double SPACING_HUNDREDTHS = 19.5;
    static final double SPACE_EM = 0.29;
    static final double CAPITAL_HEIGHT_HUNDREDTHS = 70;
    private static final double DEGREES_PER_CHORD = 12;
    private static final double MARK_LIFT_OVER_CAPITALS_HUNDREDTHS = 20;

    private final Map<Integer, Glyph> glyphs = new LinkedHashMap<>();

    private StrokeFont() {}

    static StrokeFont load() {
        try (var file = StrokeFont.class.getResourceAsStream("strokes.txt")) {
            return parse(new String(file.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    static StrokeFont parse(String text) {
        var font = new StrokeFont();
        for (var line : text.split("\n")) {
            boolean comment = line.startsWith("# ") && !Character.isDigit(line.charAt(2));
            if (!comment && !line.isBlank()) {
                font.add(line);
            }
        }
        return font;
    }

    Iterable<Glyph> glyphs() {
        return glyphs.values();
    }

    /** Returns the letter, or null. */
    Glyph glyph(int codePoint) {
        return glyphs.get(codePoint);
    }

    private void add(String line) {
        var words = line.split(" ");
        int codePoint = words[0].codePointAt(0);
        glyphs.put(codePoint, words[1].equals("=") ? composed(codePoint, words[2]) : drawn(codePoint, words));
    }

    private static Glyph drawn(int codePoint, String[] words) {
        List<List<Double>> strokes = new ArrayList<>();
        int at = 2;
        while (at < words.length) {
            String command = words[at];
            int end = at + (command.equals("A") ? 7 : 3);
            double[] numbers = Arrays.stream(words, at + 1, end)
                    .mapToDouble(Double::parseDouble)
                    .toArray();
            if (command.equals("M") || strokes.isEmpty()) {
                strokes.add(new ArrayList<>());
            }
            List<Double> stroke = strokes.get(strokes.size() - 1);
            switch (command) {
                case "M", "L" -> stroke.addAll(List.of(numbers[0], numbers[1]));
                case "A" -> addArc(numbers, stroke);
                default -> throw new IllegalArgumentException("strokes.txt: unknown pen command " + command);
            }
            at = end;
        }
        return new Glyph(
                codePoint,
                Double.parseDouble(words[1]),
                strokes.stream()
                        .map(stroke ->
                                stroke.stream().mapToDouble(Double::doubleValue).toArray())
                        .toList());
    }

    /** Adds chords far shorter than a pixel. */
    private static void addArc(double[] centreRadiiAngles, List<Double> stroke) {
        double from = centreRadiiAngles[4];
        double to = centreRadiiAngles[5];
        int chords = (int) Math.ceil(Math.abs(to - from) / DEGREES_PER_CHORD);
        for (int i = 0; i <= chords; i++) {
            double angle = Math.toRadians(from + (to - from) * i / chords);
            stroke.add(centreRadiiAngles[0] + centreRadiiAngles[2] * Math.cos(angle));
            stroke.add(centreRadiiAngles[1] + centreRadiiAngles[3] * Math.sin(angle));
        }
    }

    private Glyph composed(int codePoint, String baseAndMark) {
        var base = glyphs.get(baseAndMark.codePointAt(0));
        var mark = glyphs.get(baseAndMark.codePointAt(baseAndMark.indexOf('+') + 1));
        boolean below = mark.codePoint() == '¸';
        boolean lifted = Character.isUpperCase(base.codePoint()) && !below;
        return base.with(mark, codePoint, lifted ? MARK_LIFT_OVER_CAPITALS_HUNDREDTHS : 0);
    }
}
