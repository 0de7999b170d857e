package nephele.engine.reference;

import java.util.Arrays;
import java.util.SplittableRandom;
import nephele.engine.math.Vec3;

/**
 * The surfaces that emit light, as lights: chooses places on them with a density in proportion to the emitted power.
 * Immutable. Billboards turn to each ray, so that only paths which meet them find their light.
 */
final class EmissiveSurfaces {
    private final Emitter[] emitters;
    private final PowerTable power;

    /**
     * A place on a surface that emits light.
     *
     * @param normal unit, of the geometry
     * @param density per square metre, with which it was chosen
     */
    record Source(Vec3 place, Vec3 normal, Vec3 radiance, double density) {
        private Source over(double power) {
            return new Source(place, normal, radiance, density / power);
        }
    }

    /** The light of one item. */
    interface Emitter {
        /** Returns the emitted power: the sum of the channels of radiance times area. */
        double power();

        /**
         * Returns a random place with its density per square metre, times the power; {@code null} for one that a portal
         * cuts off.
         */
        Source source(SplittableRandom random);

        /** Returns the density, times the power, with which {@link #source} chooses the place at a path's end. */
        double density(EyePath path);
    }

    EmissiveSurfaces(TracedItems items, TracedShape.SurfaceAppearance looks) {
        emitters = new Emitter[items.count()];
        double[] powers = new double[emitters.length];
        for (int item = 0; item < emitters.length; item++) {
            emitters[item] = items.shape(item).emitter(item, looks);
            powers[item] = emitters[item] == null ? 0 : emitters[item].power();
        }
        power = new PowerTable(powers);
    }

    /** Returns the power of radiance for each square metre. */
    static double brightness(Vec3 radiance) {
        return radiance.x() + radiance.y() + radiance.z();
    }

    boolean isEmpty() {
        return power.sum() == 0;
    }

    /** Returns the density per square metre with which the place at a path's end is chosen; 0 if it never is. */
    double density(EyePath path) {
        Emitter emitter = isEmpty() ? null : emitters[path.item()];
        return emitter == null ? 0 : emitter.density(path) / power.sum();
    }

    /** Returns a random place; {@code null} for one that a portal cuts off. */
    Source source(SplittableRandom random) {
        Source source = emitters[power.chosen(random)].source(random);
        return source == null ? null : source.over(power.sum());
    }

    /** Chooses among parts by their power. */
    static final class PowerTable {
        /** The power of all parts before each, and of all. */
        private final double[] before;

        PowerTable(double[] powers) {
            before = new double[powers.length + 1];
            for (int i = 0; i < powers.length; i++) {
                before[i + 1] = before[i] + powers[i];
            }
        }

        double sum() {
            return before[before.length - 1];
        }

        /** Returns a random part, never one without power. */
        int chosen(SplittableRandom random) {
            double at = Math.min(random.nextDouble() * sum(), Math.nextDown(sum()));
            int found = Arrays.binarySearch(before, at);
            int part = found < 0 ? -found - 2 : found;
            while (before[part + 1] == before[part]) {
                part++;
            }
            return part;
        }
    }

    /** Triangles that emit light. */
    interface Triangles {
        int count();

        /** Returns corner 0 to 2, counter-clockwise seen from the front. */
        Vec3 corner(int triangle, int corner);

        /** Returns the radiance of a place on a triangle. */
        Vec3 radiance(int triangle, Vec3 place);

        /** Returns the triangle at the end of a path that ends on one, or another as bright in its middle. */
        int at(EyePath path);
    }

    /** Returns the light of triangles, each as bright as its middle; {@code null} if they are dark. */
    static Emitter of(Triangles triangles) {
        double[] powers = new double[triangles.count()];
        for (int i = 0; i < powers.length; i++) {
            double bright = brightness(inMiddle(triangles, i));
            powers[i] = bright == 0 ? 0 : bright * across(triangles, i).length() / 2;
        }
        PowerTable table = new PowerTable(powers);
        return table.sum() == 0 ? null : new OfTriangles(triangles, table);
    }

    private static Vec3 inMiddle(Triangles triangles, int i) {
        Vec3 sum = triangles.corner(i, 0).plus(triangles.corner(i, 1)).plus(triangles.corner(i, 2));
        return triangles.radiance(i, sum.scaled(1.0 / 3));
    }

    private static Vec3 across(Triangles triangles, int i) {
        Vec3 corner = triangles.corner(i, 0);
        return triangles.corner(i, 1).minus(corner).cross(triangles.corner(i, 2).minus(corner));
    }

    private record OfTriangles(Triangles triangles, PowerTable table) implements Emitter {
        @Override
        public double power() {
            return table.sum();
        }

        @Override
        public Source source(SplittableRandom random) {
            int i = table.chosen(random);
            double root = Math.sqrt(random.nextDouble());
            double along = root * random.nextDouble();
            Vec3 corner = triangles.corner(i, 0);
            Vec3 place = corner.addScaled(root - along, triangles.corner(i, 1).minus(corner))
                    .addScaled(along, triangles.corner(i, 2).minus(corner));
            Vec3 across = across(triangles, i);
            double density = brightness(inMiddle(triangles, i));
            return new Source(place, across.scaled(1 / across.length()), triangles.radiance(i, place), density);
        }

        @Override
        public double density(EyePath path) {
            return brightness(inMiddle(triangles, triangles.at(path)));
        }
    }
}
