package nephele.engine.atmosphere;

/**
 * Sunlight scattered once: the first colour by molecules, the second by aerosols. The phase functions, which are the same
 * all along a ray, are left to be multiplied.
 */
final class SingleScattering implements AirSource {
    private final Air air;
    private final Sunlight sun;
    private final double[] sunlight = new double[Air.CHANNELS];

    SingleScattering(Air air, Sunlight sun) {
        this.air = air;
        this.sun = sun;
    }

    /** Returns the same light as one colour, with the phase functions of the ray, for one thread. */
    static AirSource withPhases(AirTables tables) {
        Air air = tables.air();
        AirSource once = new SingleScattering(air, tables.sunlight());
        double[] single = new double[2 * Air.CHANNELS];
        return (ray, radiancePerMetre) -> {
            once.put(ray, single);
            double rayleigh = Air.rayleighPhase(ray.betweenCosine());
            double mie = air.miePhase(ray.betweenCosine());
            for (int c = 0; c < Air.CHANNELS; c++) {
                radiancePerMetre[c] = rayleigh * single[c] + mie * single[Air.CHANNELS + c];
            }
        };
    }

    @Override
    public int colours() {
        return 2;
    }

    @Override
    public void put(AirRay ray, double[] radiancePerMetre) {
        sun.put(ray.pointHeightMetres(), ray.pointSunCosine(), sunlight);
        double mie = air.miePerMetre() * ray.pointAerosols();
        for (int c = 0; c < Air.CHANNELS; c++) {
            radiancePerMetre[c] = sunlight[c] * Air.rayleighPerMetre(c) * ray.pointMolecules();
            radiancePerMetre[Air.CHANNELS + c] = sunlight[c] * mie;
        }
    }
}
