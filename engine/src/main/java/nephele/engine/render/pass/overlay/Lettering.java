package nephele.engine.render.pass.overlay;

/** The font atlas, created at the first text, so that a game without an overlay has none. */
public final class Lettering {
    private FontAtlas atlas;

    /** Returns the advance of a letter. */
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
