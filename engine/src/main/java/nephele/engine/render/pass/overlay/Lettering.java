package nephele.engine.render.pass.overlay;

/** The letters ready for use, baked at the first text: a game without an overlay has none. */
public final class Lettering {
    private FontAtlas atlas;

    /** How far a letter moves the pen. */
    double advanceEm(int codePoint) {
        return codePoint == ' ' ? StrokeFont.SPACE_EM : cell(codePoint).advanceEm();
    }

    FontAtlas.Cell cell(int codePoint) {
        return atlas().cell(codePoint);
    }

    FontAtlas atlas() {
        if (atlas == null) {
            atlas = FontAtlas.bake(StrokeFont.load());
        }
        return atlas;
    }
}
