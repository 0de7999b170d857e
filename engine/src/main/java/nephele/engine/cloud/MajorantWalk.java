package nephele.engine.cloud;

/** Successive, disjoint segments of a ray, each with an upper bound of the extinction. Belongs to one thread. */
public interface MajorantWalk {
    /** Goes to the next segment, at first to the first one. @return false if there is none */
    boolean next();

    /** Returns the ray parameter in metres at which the segment begins. */
    double fromMetres();

    /** Returns the ray parameter in metres at which the segment ends; more than {@link #fromMetres}. */
    double toMetres();

    /** Returns an upper bound, above 0, of the extinction per metre on the segment. */
    double perMetre();
}
