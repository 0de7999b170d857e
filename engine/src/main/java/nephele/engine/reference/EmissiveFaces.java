package nephele.engine.reference;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.level.Brush;
import nephele.engine.level.Material;
import nephele.engine.math.Vec3;

/**
 * The emissive faces of solids as lights: chooses points on them with a density in proportion to the emitted power.
 * Immutable. Emissive models, terrain and bodies are lights too, but only found by paths that happen to meet them.
 */
final class EmissiveFaces {
    private final List<Triangle> triangles = new ArrayList<>();
    private final List<Double> powerBefore = new ArrayList<>();
    private final Map<Long, Double> powerPerSquareMetre = new HashMap<>();
    private double power;

    private record Triangle(Vec3 corner, Vec3 first, Vec3 second, Vec3 normal, Vec3 radiance) {}

    /**
     * A point of an emissive face.
     *
     * @param density per square metre, with which it was chosen
     */
    record Source(Vec3 place, Vec3 normal, Vec3 radiance, double density) {}

    EmissiveFaces(List<Brush> brushes, MaterialTextures textures) {
        for (int item = 0; item < brushes.size(); item++) {
            List<Brush.BrushFace> faces = brushes.get(item).faces();
            for (int face = 0; face < faces.size(); face++) {
                Material material = textures.skin(faces.get(face).material()).material();
                Vec3 emission = material.emission();
                if (weight(emission) > 0 && !material.mirror()) { // paths reflect at a mirror and never end on it
                    add(item, face, faces.get(face), emission);
                }
            }
        }
    }

    private static double weight(Vec3 radiance) {
        return radiance.x() + radiance.y() + radiance.z();
    }

    private void add(int item, int index, Brush.BrushFace face, Vec3 emission) {
        List<Vec3> polygon = face.polygon();
        powerPerSquareMetre.put(key(item, index), weight(emission));
        for (int i = 2; i < polygon.size(); i++) {
            Vec3 first = polygon.get(i - 1).minus(polygon.get(0));
            Vec3 second = polygon.get(i).minus(polygon.get(0));
            triangles.add(
                    new Triangle(polygon.get(0), first, second, face.plane().normal(), emission));
            powerBefore.add(power);
            power += first.cross(second).length() / 2 * weight(emission);
        }
    }

    private static long key(int item, int face) {
        return (long) item << 32 | face;
    }

    boolean isEmpty() {
        return power == 0;
    }

    /** Returns the density per square metre with which the points of a face are chosen; 0 if it emits nothing. */
    double density(int item, int face) {
        return isEmpty() ? 0 : powerPerSquareMetre.getOrDefault(key(item, face), 0.0) / power;
    }

    /** Returns a random point. */
    Source source(SplittableRandom random) {
        Triangle in = triangles.get(chosen(random.nextDouble() * power));
        double root = Math.sqrt(random.nextDouble());
        double along = root * random.nextDouble();
        Vec3 place = in.corner.addScaled(root - along, in.first).addScaled(along, in.second);
        return new Source(place, in.normal, in.radiance, weight(in.radiance) / power);
    }

    private int chosen(double at) {
        int low = 0;
        int high = triangles.size() - 1;
        while (low < high) {
            int middle = (low + high + 1) >>> 1;
            if (powerBefore.get(middle) <= at) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        return low;
    }
}
