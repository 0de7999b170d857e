package nephele.engine.cloud.octave;

import java.util.List;

/** The noise of clouds that are drawn by technique {@code procedural}. */
public enum ProceduralNoise {
    /** Gradient noise without a period, whose octaves keep their variance while they change. */
    SMOOTH(List.of(1 / 2.0, 1 / 4.0, 1 / 8.0, 1 / 16.0, 1 / 32.0)),
    /** White noise of 32², 64² and 128² texels, enlarged bilinearly, cross-faded linearly, with weights ½, ¼ and ⅛. */
    SOURCE(List.of(1 / 2.0, 1 / 4.0, 1 / 8.0)),
    /** The same with the weights of octaves that are blended one over the other, each with half, a quarter, an eighth. */
    SOURCE_CODE(List.of(1 / 2.0 * (3 / 4.0) * (7 / 8.0), 1 / 4.0 * (7 / 8.0), 1 / 8.0));

    private final List<Double> weights;

    ProceduralNoise(List<Double> weights) {
        this.weights = weights;
    }

    /** Returns the weights of the octaves, the widest one's first. */
    public List<Double> weights() {
        return weights;
    }

    public boolean isSmooth() {
        return this == SMOOTH;
    }
}
