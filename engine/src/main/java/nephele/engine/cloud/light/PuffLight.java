package nephele.engine.cloud.light;

/** The model of sunlight in clouds that are drawn as soft balls. */
public enum PuffLight {
    /** {@link CloudLight}, as in clouds that are marched: what is scattered often is found too. */
    TAIL,
    /**
     * Light that is scattered once (Dobashi, Kaneda, Yamashita, Okita and Nishita 2000, "A Simple, Efficient Method for Realistic
     * Animation of Clouds").
     */
    DOBASHI,
    /** Light that is scattered towards the eye once, and before that any number of times forwards: {@link BeamLight#forwards}. */
    HARRIS;

    /** Returns the light that is accumulated along the beam; {@code null} for the tail, which has more. */
    public BeamLight beam(CloudOptics optics) {
        return switch (this) {
            case TAIL -> null;
            case DOBASHI -> BeamLight.once(optics);
            case HARRIS -> BeamLight.forwards(optics);
        };
    }
}
