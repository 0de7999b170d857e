package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.LongUnaryOperator;
import java.util.stream.IntStream;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.level.layout.FacePieces;
import nephele.engine.math.Hash64;
import nephele.engine.math.Isometry;
import nephele.engine.math.Plane;
import nephele.engine.math.Reflection;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.engine.reference.volume.DistantLight;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Direct light of sun, moon and lamps that reaches a surface or a place in a cloud through open portals and off mirrors.
 * Through each word, a sequence of portals and mirrors, a light has an image; a ray towards it counts if it meets just
 * that word and nothing blocks it. Words are followed as deep as the solid angle of what is visible through their last
 * opening survives Russian roulette. Use one per thread.
 */
final class LightImages {
    /** The solid angle from which on words survive as often as any. */
    private static final double SURE_STERADIANS = 0.5;

    /** A survival below 1 ends the words of openings that face each other at any distance. */
    private static final double MOST_SURVIVAL = 0.9;

    private final List<Opening> openings = new ArrayList<>();
    private final EyePath path;
    private final Illumination light;
    private final List<Opening> word = new ArrayList<>();
    private PathVertex lit;
    private List<DistantLight> distant;
    private SplittableRandom random;
    private Vector3d sum;

    /**
     * A portal or a mirror.
     *
     * @param polygon its corners
     * @param entry its plane, the front in front
     * @param exit the plane behind which an image of what is before the opening is
     * @param through maps to the space behind the opening, {@code back} inverts it
     * @param hash extends that of a path, see {@link EyePath#pathHash}
     */
    private record Opening(
            List<Vec3> polygon, Plane entry, Plane exit, Isometry through, Isometry back, LongUnaryOperator hash) {}

    /**
     * What is visible of the world behind a word.
     *
     * @param from the vertex as it is visible from there
     * @param polygon the part of the last opening through which it sees
     * @param edges planes through the vertex and the edges of the polygon, which is behind them
     */
    private record Window(Vector3dc from, List<Vec3> polygon, List<Plane> edges) {
        static Window of(Vector3dc from, List<Vec3> polygon) {
            Vec3 eye = Vec3.of(from);
            Vec3 sum = Vec3.ZERO;
            for (Vec3 corner : polygon) {
                sum = sum.plus(corner.minus(eye));
            }
            List<Plane> edges = new ArrayList<>();
            for (int i = 0; i < polygon.size(); i++) {
                Vec3 across = polygon.get(i)
                        .minus(eye)
                        .cross(polygon.get((i + 1) % polygon.size()).minus(eye));
                double length = across.length();
                if (length > 0) {
                    Vec3 normal = across.scaled((across.dot(sum) > 0 ? -1 : 1) / length);
                    edges.add(Plane.through(normal, eye));
                }
            }
            return new Window(from, polygon, edges);
        }

        boolean contains(Vec3 direction) {
            return edges.stream().allMatch(edge -> edge.normal().dot(direction) <= 0);
        }

        /** Returns the solid angle (Van Oosterom and Strackee 1983, equation 8). */
        double steradians() {
            Vec3 eye = Vec3.of(from);
            Vec3[] towards = polygon.stream()
                    .map(corner -> corner.minus(eye))
                    .map(v -> v.scaled(1 / v.length()))
                    .toArray(Vec3[]::new);
            double angle = 0;
            for (int i = 2; i < towards.length; i++) {
                Vec3 a = towards[0];
                Vec3 b = towards[i - 1];
                Vec3 c = towards[i];
                double volume = Math.abs(a.dot(b.cross(c)));
                angle += 2 * StrictMath.atan2(volume, 1 + a.dot(b) + b.dot(c) + c.dot(a));
            }
            return angle;
        }
    }

    /**
     * Collects the openings.
     *
     * @param portals that light passes
     * @param path that passes these portals
     */
    LightImages(Portals portals, List<FaceMaterials.Mirror> mirrors, EyePath path, Illumination light) {
        this.path = path;
        this.light = light;
        IntStream.range(0, portals.size()).filter(portals::isOpen).forEach(i -> {
            int partner = portals.partner(i);
            openings.add(new Opening(
                    portals.portal(i).corners(),
                    portals.plane(i),
                    portals.plane(partner),
                    portals.transform(i),
                    portals.transform(partner),
                    hash -> Hash64.combine(hash, i)));
        });
        for (FaceMaterials.Mirror mirror : mirrors) {
            Isometry image =
                    new Reflection(mirror.polygon().get(0), mirror.plane().normal());
            openings.add(new Opening(
                    mirror.polygon(),
                    mirror.plane(),
                    mirror.plane(),
                    image,
                    image,
                    hash -> EyePath.hashOfMirror(hash, mirror.solid(), mirror.face())));
        }
    }

    /**
     * Returns a random RGB radiance towards the eye whose mean is the vertex's by light through openings.
     *
     * @param lights from outside that cast shadows
     */
    Vector3d radiance(PathVertex at, List<DistantLight> lights, SplittableRandom numbers) {
        lit = at;
        distant = lights;
        random = numbers;
        sum = new Vector3d();
        word.clear();
        follow(at.rayOrigin(), null, 1, 0);
        return sum;
    }

    /**
     * Follows all words that begin with the current one.
     *
     * @param from the vertex as it is visible from behind the word
     * @param before what is visible behind the word; {@code null} for all of the world
     * @param strength the inverse of the probability that roulette has followed the word
     * @param hash of the word
     */
    private void follow(Vector3dc from, Window before, double strength, long hash) {
        for (Opening opening : openings) {
            List<Vec3> part = opening.entry.signedDistance(from.x(), from.y(), from.z()) > 0
                    ? visible(opening.polygon, before)
                    : List.of();
            if (part.size() < 3) {
                continue;
            }
            Vector3d beyond = opening.through.point(new Vector3d(from));
            Window window =
                    Window.of(beyond, part.stream().map(opening.through::point).toList());
            double survival = word.isEmpty() ? 1 : Math.min(MOST_SURVIVAL, window.steradians() / SURE_STERADIANS);
            if (survival < 1 && random.nextDouble() >= survival) {
                continue;
            }
            word.add(opening);
            long hashBeyond = opening.hash.applyAsLong(hash);
            addLights(window, strength / survival, hashBeyond);
            follow(beyond, window, strength / survival, hashBeyond);
            word.remove(word.size() - 1);
        }
    }

    /** Returns the part of an opening that is visible behind the word; fewer than three corners if it is not. */
    private List<Vec3> visible(List<Vec3> polygon, Window before) {
        if (before == null) {
            return lit instanceof SurfacePoint surface
                    ? FacePieces.behind(
                            polygon, Plane.through(Vec3.of(surface.faceNormal()).negated(), surface.place()))
                    : polygon;
        }
        List<Vec3> part =
                FacePieces.behind(polygon, word.get(word.size() - 1).exit.opposite());
        for (Plane edge : before.edges) {
            part = part.size() < 3 ? part : FacePieces.behind(part, edge);
        }
        return part;
    }

    private void addLights(Window window, double strength, long hash) {
        Vec3 beyond = Vec3.of(window.from);
        for (DistantLight far : distant) {
            if (window.contains(far.towards())) {
                Vector3d irradiance = far.irradiance(window.polygon.get(0)).toVector();
                add(beforeWord(far.towards()), Double.POSITIVE_INFINITY, irradiance, strength, hash);
            }
        }
        for (PunctualLight lamp : light.lamps()) {
            Vec3 towards = lamp.position().minus(beyond);
            boolean mayReach = lamp.source().castsShadow() && towards.length() < lamp.rangeMetres();
            if (mayReach && window.contains(towards)) {
                add(beforeWord(towards), 1, lamp.irradianceAt(beyond), strength, hash);
            }
        }
    }

    /** Returns a direction behind the word as it is before it. */
    private Vector3d beforeWord(Vec3 direction) {
        Vector3d before = direction.toVector();
        for (int i = word.size() - 1; i >= 0; i--) {
            word.get(i).back.direction(before);
        }
        return before;
    }

    /** @param end parameter of the light along {@code towards} */
    private void add(Vector3d towards, double end, Vector3dc irradiance, double strength, long hash) {
        if (!lit.isReachedFrom(towards) || irradiance.x() + irradiance.y() + irradiance.z() == 0) {
            return;
        }
        boolean isBlocked = path.trace(lit.rayOrigin(), towards, 0, end);
        if (isBlocked || path.pathHash() != hash) {
            return;
        }
        double passed = strength;
        for (EyePath.Segment segment : path.segments()) {
            passed *= light.passedByClouds(
                    segment.origin().toVector(), segment.direction().toVector(), segment.metres(), random);
        }
        sum.add(lit.reflected(towards.normalize())
                .mul(irradiance)
                .mul(path.tint())
                .mul(passed));
    }
}
