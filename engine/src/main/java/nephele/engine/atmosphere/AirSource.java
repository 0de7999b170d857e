package nephele.engine.atmosphere;

/** Light that a metre of air sends along a ray. */
interface AirSource {
    /** Returns how many colours are put. */
    default int colours() {
        return 1;
    }

    /** Puts the radiance per metre at the point that the ray looks at, per unit solar irradiance: colour by colour. */
    void put(AirRay ray, double[] radiancePerMetre);
}
