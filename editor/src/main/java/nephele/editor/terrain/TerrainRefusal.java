package nephele.editor.terrain;

import nephele.editor.text.Words;

/** The reason why a terrain cannot be painted. */
public final class TerrainRefusal extends Exception {
    private static final long serialVersionUID = 1;

    private final transient Words told;

    TerrainRefusal(Words told) {
        super(told.english());
        this.told = told;
    }

    public Words told() {
        return told;
    }
}
