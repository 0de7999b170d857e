package nephele.engine.reference;

/**
 * How far light is followed.
 *
 * @param bounces the greatest number of surfaces that light meets before the one that the eye sees
 * @param passesPortals true if light passes open portals as eye rays do; meaningless without bounces
 */
public record LightTransport(int bounces, boolean passesPortals) {
    /** Raise it whenever a picture of light that bounces changes while none of direct light does. */
    private static final int REVISION = 5;

    /** Light straight from sun, sky and lamps. */
    public static final LightTransport DIRECT = new LightTransport(0, false);

    /** All light: what is left of a path is decided by Russian roulette alone. */
    public static final LightTransport FULL = new LightTransport(Integer.MAX_VALUE, true);

    /** All light as a bake has it, which no portals let pass. */
    public static final LightTransport BAKED = new LightTransport(FULL.bounces, false);

    public LightTransport {
        if (bounces < 0) {
            throw new IllegalArgumentException("bounces below 0: " + bounces);
        }
    }

    /** Returns words for keys of kept pictures; none for {@link #DIRECT}, whose keys are older than bounces. */
    public String key() {
        String portals = passesPortals ? " through portals" : "";
        return bounces == 0 ? "" : " bounces " + bounces + portals + " revision " + REVISION;
    }
}
