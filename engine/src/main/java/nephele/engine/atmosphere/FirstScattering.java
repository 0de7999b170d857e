package nephele.engine.atmosphere;

/** Sunlight that the air scatters once into a ray, as one colour; the phase functions of the ray are included. */
final class FirstScattering implements AirSource {
    private final Air air;
    private final SingleScattering once;
    private final double[] single = new double[2 * Air.CHANNELS];

    FirstScattering(AirTables tables) {
        air = tables.air();
        once = new SingleScattering(air, tables.sunlight());
    }

    @Override
    public int colours() {
        return 1;
    }

    @Override
    public void put(AirRay ray, double[] radiancePerMetre) {
        once.put(ray, single);
        double rayleigh = Air.rayleighPhase(ray.betweenCosine());
        double mie = air.miePhase(ray.betweenCosine());
        for (int c = 0; c < Air.CHANNELS; c++) {
            radiancePerMetre[c] = rayleigh * single[c] + mie * single[Air.CHANNELS + c];
        }
    }
}
