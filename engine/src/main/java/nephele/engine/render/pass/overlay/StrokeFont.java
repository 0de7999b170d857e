package nephele.engine.render.pass.overlay;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;

/** The letters of {@code strokes.txt}, which documents their notation. */
final class StrokeFont {
    /** Width of the pen and the free space between the pens of two letters, in hundredths of an em. */
    static final double PEN_HUNDREDTHS = 8.5;

    static final double SPACING_HUNDREDTHS = 19.5;
    static final double SPACE_EM = 0.29;
    static final double CAPITAL_HEIGHT_HUNDREDTHS = 70;
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
        var pen = new PenPath();
        for (int i = 2; i < words.length; ) {
            i += pen.follow(words, i);
        }
        return new Glyph(codePoint, Double.parseDouble(words[1]), pen.strokes());
    }

    private Glyph composed(int codePoint, String baseAndMark) {
        var base = glyphs.get(baseAndMark.codePointAt(0));
        var mark = glyphs.get(baseAndMark.codePointAt(baseAndMark.indexOf('+') + 1));
        boolean below = mark.codePoint() == '¸';
        boolean lifted = Character.isUpperCase(base.codePoint()) && !below;
        return base.with(mark, codePoint, lifted ? MARK_LIFT_OVER_CAPITALS_HUNDREDTHS : 0);
    }
}
