package nephele.engine.cloud.drawn;

/** The shape of the sheet as which a layer of clouds is drawn. */
public enum SkyplaneShape {
    /** A sphere around the planet under an atmosphere, otherwise a plane. */
    SHELL,
    FLAT,
    /**
     * A mesh of 17 × 17 vertices around the eye that sinks by the square of the distance, 2√(R₂² − R₁²) wide and R₁
     * above the eye, with R₂ = 9 R₁.
     */
    CURVED,
    /** A hemisphere around the eye. */
    DOME
}
