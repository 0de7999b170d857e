package nephele.engine.level.layout;

import nephele.engine.level.Level;
import nephele.engine.level.Solid;

/** JSON paths of solids and their faces. */
public final class FacePath {
    private FacePath() {}

    /** Returns the path of a solid, such as {@code solids[3]}. */
    public static String of(int solid) {
        return "solids[" + solid + "]";
    }

    /**
     * Returns the path where a face's own properties are written; that of the solid if its faces have none.
     *
     * @param face name of the face
     */
    public static String of(Level level, int solid, String face) {
        Solid authored = level.solids().get(solid);
        if (authored instanceof Solid.Planes) {
            return of(solid) + "." + face;
        }
        boolean hasFaces = authored instanceof Solid.Box || authored instanceof Solid.Wedge;
        return hasFaces ? of(solid) + ".faces." + face : of(solid);
    }

    /** Returns a solid's path and id for messages. */
    public static String named(Level level, int solid) {
        return of(solid) + " ('" + level.solids().get(solid).id() + "')";
    }
}
