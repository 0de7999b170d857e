package nephele.editor.terrain;

import nephele.editor.text.Words;

/**
 * A round brush for terrains. It works in dabs: a stroke makes one where it begins and one each quarter of the radius
 * along its path. The effect of a dab falls from the middle to the border as (1 − d²)², d being the distance divided by
 * the radius.
 *
 * @param radiusMetres horizontal, {@link #LEAST_METRES} to {@link #MOST_METRES}
 * @param strength the effect of a dab in its middle, above 0 and up to 1: raising and lowering, in fifths of the radius;
 *     otherwise the fraction of the difference to the result
 * @param layer the index of the layer that painting shows, 0 to {@link #LAST_LAYER}
 */
public record TerrainBrush(Effect effect, double radiusMetres, double strength, int layer) {
    public static final double LEAST_METRES = 0.25;
    public static final double MOST_METRES = 1024;

    /** The last layer that a terrain can have. */
    public static final int LAST_LAYER = 7;

    /** The brush of a new session. */
    public static final TerrainBrush INITIAL = new TerrainBrush(Effect.RAISE, 8, 0.25);

    private static final double LEAST_STRENGTH = 1.0 / 64;
    private static final double RISE_PER_RADIUS = 0.2;

    /** What a brush does to heights, and the last two to painted layers. */
    public enum Effect {
        RAISE(Words.of("Raise Terrain", "Elevar terreno", "Elevar terreno")),
        LOWER(Words.of("Lower Terrain", "Rebaixar terreno", "Rebaixar terreno")),
        /** Moves each height towards the mean around it. */
        SMOOTH(Words.of("Smooth Terrain", "Suavizar terreno", "Suavizar terreno")),
        /** Moves heights to the one at which the stroke began. */
        FLATTEN(Words.of("Flatten Terrain", "Aplanar terreno", "Aplanar terreno")),
        /** Shows a layer whatever the height and the slope. */
        PAINT(Words.of("Paint Layer", "Pintar camada", "Pintar camada")),
        /** Takes paint of all layers away. */
        ERASE(Words.of("Erase Paint", "Apagar pintura", "Apagar pintura"));

        private final Words title;

        Effect(Words title) {
            this.title = title;
        }

        public Words title() {
            return title;
        }

        /** Returns true if the effect is one on painted layers, not on heights. */
        public boolean isPaint() {
            return this == PAINT || this == ERASE;
        }

        /** Returns the effect with the Shift key held: raising and lowering, painting and erasing change places. */
        public Effect inverted() {
            return switch (this) {
                case RAISE -> LOWER;
                case LOWER -> RAISE;
                case PAINT -> ERASE;
                case ERASE -> PAINT;
                case SMOOTH, FLATTEN -> this;
            };
        }
    }

    public TerrainBrush {
        radiusMetres = Math.max(LEAST_METRES, Math.min(radiusMetres, MOST_METRES));
        strength = Math.max(LEAST_STRENGTH, Math.min(strength, 1));
        layer = Math.max(0, Math.min(layer, LAST_LAYER));
    }

    /** Creates a brush that paints the first layer. */
    public TerrainBrush(Effect effect, double radiusMetres, double strength) {
        this(effect, radiusMetres, strength, 0);
    }

    public TerrainBrush with(Effect other) {
        return new TerrainBrush(other, radiusMetres, strength, layer);
    }

    /** Returns a brush of another radius. */
    public TerrainBrush ofRadius(double metres) {
        return new TerrainBrush(effect, metres, strength, layer);
    }

    /** Returns a brush of another strength. */
    public TerrainBrush ofStrength(double fraction) {
        return new TerrainBrush(effect, radiusMetres, fraction, layer);
    }

    /** Returns a brush that paints another layer. */
    public TerrainBrush ofLayer(int index) {
        return new TerrainBrush(effect, radiusMetres, strength, index);
    }

    /** Returns the rise of a raising dab in its middle. */
    public double riseMetres() {
        return RISE_PER_RADIUS * strength * radiusMetres;
    }

    /** Returns the falloff at a fraction of the radius, squared. */
    static double falloff(double fractionSquared) {
        double left = Math.max(0, 1 - fractionSquared);
        return left * left;
    }
}
