package nephele.editor.brush;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** Random valid solids of every kind, some metres large and around the origin, with faces of their own. */
final class RandomSolids {
    private static final String[] MATERIALS = {null, "brick", "tile"};

    private final SplittableRandom random;

    RandomSolids(long seed) {
        random = new SplittableRandom(seed);
    }

    SplittableRandom random() {
        return random;
    }

    /** Returns a solid whose numbers are multiples of 1/8 m, oblique planes excepted. */
    Solid next() {
        return switch (random.nextInt(5)) {
            case 0 -> box();
            case 1 -> wedge();
            case 2 -> prism();
            default -> planes();
        };
    }

    /** Returns a multiple of 1/8. */
    double eighths(double from, double to) {
        return Math.rint((from + random.nextDouble() * (to - from)) * 8) / 8 + 0.0;
    }

    Vec3 point(double reach) {
        return new Vec3(eighths(-reach, reach), eighths(-reach, reach), eighths(-reach, reach));
    }

    /** Returns any direction. */
    Vec3 direction() {
        Vec3 v = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
        return v.length() > 0.1 ? v : direction();
    }

    private Vec3 size() {
        return new Vec3(eighths(1, 5), eighths(1, 5), eighths(1, 5));
    }

    private String material() {
        return MATERIALS[random.nextInt(MATERIALS.length)];
    }

    private Solid.Face face() {
        return new Solid.Face(random.nextBoolean() ? "brick" : "metal", random.nextBoolean(), null);
    }

    Solid.Box box() {
        Map<BoxFace, Solid.Face> faces = new EnumMap<>(BoxFace.class);
        faces.put(BoxFace.values()[random.nextInt(6)], face());
        return new Solid.Box("box", material(), random.nextBoolean(), TextureMapping.WORLD, point(2), size(), faces);
    }

    Solid.Wedge wedge() {
        BoxFace[] risings = {BoxFace.PLUS_X, BoxFace.MINUS_X, BoxFace.PLUS_Z, BoxFace.MINUS_Z};
        BoxFace rising = risings[random.nextInt(4)];
        Map<String, Solid.Face> faces = new HashMap<>();
        faces.put(random.nextBoolean() ? "slope" : rising.text(), face());
        return new Solid.Wedge(
                "wedge", material(), random.nextBoolean(), TextureMapping.FACE, point(2), size(), rising, faces);
    }

    Solid.Prism prism() {
        return new Solid.Prism(
                "prism",
                material(),
                random.nextBoolean(),
                TextureMapping.WORLD,
                point(2),
                eighths(1, 3),
                eighths(1, 4),
                3 + random.nextInt(8),
                Map.of());
    }

    /** Returns a box with random corners cut off. */
    Solid.Planes planes() {
        Solid.Box box = box();
        List<PlaneFace> planes = new ArrayList<>();
        for (BoxFace side : BoxFace.values()) {
            double distance =
                    side.normal().dot(box.centre()) + Math.abs(side.normal().dot(box.size())) / 2;
            planes.add(new PlaneFace(side.normal(), distance, null, null, null));
        }
        for (int i = random.nextInt(1, 5); i > 0; i--) {
            Vec3 normal = Plane.of(direction(), 0).normal();
            double distance = ExactNumber.snapped(normal.dot(box.centre()) + 0.5 + random.nextDouble() / 2);
            planes.add(new PlaneFace(normal, distance, random.nextBoolean() ? "metal" : null, null, null));
        }
        return PlaneForm.of(new Solid.Planes("planes", material(), random.nextBoolean(), TextureMapping.WORLD, planes));
    }
}
