package nephele.engine.render.pass.overlay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class StrokeFontTest {
    private final StrokeFont font = StrokeFont.load();

    @Test
    void everyPrintableAsciiAndPortugueseLetterIsThere() {
        for (int codePoint = '!'; codePoint <= '~'; codePoint++) {
            assertNotNull(font.glyph(codePoint), Character.toString(codePoint));
        }
        "áàâãéêíóôõúüçÁÀÂÃÉÊÍÓÔÕÚÜÇºª–—…×→"
                .codePoints()
                .forEach(codePoint -> assertNotNull(font.glyph(codePoint), Character.toString(codePoint)));
    }

    @Test
    void everyStrokeStaysInsideItsCell() {
        for (var glyph : font.glyphs()) {
            for (var stroke : glyph.strokes()) {
                for (int i = 0; i < stroke.length; i += 2) {
                    var name = Character.toString(glyph.codePoint()) + " at " + stroke[i] + ", " + stroke[i + 1];
                    assertTrue(stroke[i] >= -8 && stroke[i] <= glyph.widthHundredths() + 8, name);
                    assertTrue(stroke[i + 1] >= -22 && stroke[i + 1] <= 95, name);
                }
            }
        }
    }

    @Test
    void theFieldIsTheDistanceToThePen() {
        var atlas = FontAtlas.of(StrokeFont.parse("l 0 M 0 0 L 0 70"));
        var cell = atlas.cell('l');
        int row = (int) FontAtlas.baselineTexels() + 20;
        double halfPen = StrokeFont.PEN_HUNDREDTHS / 200 * FontAtlas.TEXELS_PER_EM;
        for (int column = 0; column < cell.width(); column++) {
            double distance = Math.abs(column + 0.5 - FontAtlas.originTexels());
            double expected = 128 + (halfPen - distance) * FontAtlas.STEPS_PER_TEXEL;
            int found = atlas.texels()[(cell.y() + row) * FontAtlas.WIDTH_TEXELS + cell.x() + column] & 255;
            assertEquals(Math.max(0, Math.min(255, expected)), found, 0.51);
        }
    }

    @Test
    void neighboursInTheAtlasDoNotTouch() {
        var atlas = FontAtlas.of(font);
        for (var glyph : font.glyphs()) {
            var cell = atlas.cell(glyph.codePoint());
            for (int row = 0; row < cell.height(); row++) {
                int start = (cell.y() + row) * FontAtlas.WIDTH_TEXELS + cell.x();
                assertEquals(0, atlas.texels()[start], "left edge of " + Character.toString(glyph.codePoint()));
                assertEquals(0, atlas.texels()[start + cell.width() - 1]);
            }
        }
    }

    @Test
    void aLetterThatTheFontLacksIsAQuestionMark() {
        var atlas = FontAtlas.of(font);
        assertEquals(atlas.cell('?'), atlas.cell(0x4e2d));
    }
}
