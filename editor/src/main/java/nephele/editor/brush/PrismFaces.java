package nephele.editor.brush;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntUnaryOperator;
import java.util.function.UnaryOperator;
import nephele.engine.level.Solid;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.math.Vec3;

/** Renames the face entries of a prism after a quarter turn or a reflection. */
final class PrismFaces {
    /** The two ends come before the sides among a prism's faces. */
    private static final int FIRST_SIDE = 2;

    private PrismFaces() {}

    /** Turns the sides by quarters about +y; their number times the quarters is a multiple of 4. */
    static Solid.Prism turned(Solid.Prism prism, int quarters) {
        // Sides are counted from +x towards +z, turns go from +x towards -z.
        int places = prism.sides() * quarters / 4;
        return renamed(prism, side -> side - places, end -> end);
    }

    /** Mirrors the faces along the axes whose factors are negative; along x only with an even number of sides. */
    static Solid.Prism mirrored(Solid.Prism prism, Vec3 factors) {
        int half = factors.x() < 0 ? prism.sides() / 2 : 0;
        int sense = factors.x() * factors.z() < 0 ? -1 : 1;
        UnaryOperator<String> ends = factors.y() < 0 ? PrismFaces::oppositeEnd : end -> end;
        return renamed(prism, side -> half + sense * side, ends);
    }

    /** Leaves names of no face as they are. */
    private static String oppositeEnd(String end) {
        return switch (end) {
            case "+y" -> "-y";
            case "-y" -> "+y";
            default -> end;
        };
    }

    private static Solid.Prism renamed(Solid.Prism prism, IntUnaryOperator sides, UnaryOperator<String> ends) {
        List<String> names = SolidFaces.names(prism);
        Map<String, Solid.Face> faces = new LinkedHashMap<>();
        prism.faces().forEach((name, said) -> {
            int at = names.indexOf(name);
            boolean isSide = at >= FIRST_SIDE;
            int side = Math.floorMod(sides.applyAsInt(at - FIRST_SIDE), prism.sides());
            faces.put(isSide ? names.get(FIRST_SIDE + side) : ends.apply(name), said);
        });
        return prism.withFaces(Collections.unmodifiableMap(faces));
    }
}
