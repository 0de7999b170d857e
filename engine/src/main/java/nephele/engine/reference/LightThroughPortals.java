package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.reference.volume.DistantLight;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Direct light of sun, moon and lamps that reaches a surface or a place in a cloud through open portals. Through each crossing word, a sequence of
 * portals, a light has an image; a ray towards it counts if it crosses just that word and nothing blocks it. Words are
 * followed as deep as the solid angle of their last portal survives Russian roulette. Use one per thread.
 */
final class LightThroughPortals {
    /** The solid angle of a portal from which on its words always survive. */
    private static final double SURE_STERADIANS = 0.5;

    /** A survival below 1 ends the words of portals that face each other at any distance. */
    private static final double MOST_SURVIVAL = 0.9;

    private final Portals portals;
    private final int[] open;
    private final EyePath path;
    private final Illumination light;
    private final List<Integer> word = new ArrayList<>();
    private PathVertex lit;
    private List<DistantLight> distant;
    private SplittableRandom random;
    private Vector3d sum;

    /** @param path that passes these portals */
    LightThroughPortals(Portals portals, EyePath path, Illumination light) {
        this.portals = portals;
        this.path = path;
        this.light = light;
        open = IntStream.range(0, portals.size()).filter(portals::isOpen).toArray();
    }

    /**
     * Returns a random RGB radiance towards the eye whose mean is the vertex's by light through portals.
     *
     * @param lights from outside that cast shadows
     */
    Vector3d radiance(PathVertex at, List<DistantLight> lights, SplittableRandom numbers) {
        lit = at;
        distant = lights;
        random = numbers;
        sum = new Vector3d();
        word.clear();
        follow(at.rayOrigin(), 1, 0);
        return sum;
    }

    /**
     * Follows all words that begin with the current one.
     *
     * @param from the vertex as it is visible from behind the word's portals
     * @param strength the inverse of the probability that roulette has followed the word
     * @param hash of the word, as {@link EyePath#pathHash}
     */
    private void follow(Vector3d from, double strength, long hash) {
        for (int entry : open) {
            double angle = steradians(portals.portal(entry), from);
            if (angle <= 0 || !mayFollow(entry)) {
                continue;
            }
            double survival = word.isEmpty() ? 1 : Math.min(MOST_SURVIVAL, angle / SURE_STERADIANS);
            if (survival < 1 && random.nextDouble() >= survival) {
                continue;
            }
            word.add(entry);
            Vector3d beyond = portals.transform(entry).point(new Vector3d(from));
            long hashBeyond = Hash64.combine(hash, entry);
            addLights(beyond, strength / survival, hashBeyond);
            follow(beyond, strength / survival, hashBeyond);
            word.remove(word.size() - 1);
        }
    }

    /** Returns about the solid angle of a portal from a point, at most; 0 from behind it. */
    private static double steradians(Portal portal, Vector3dc from) {
        double before = portal.inFront(from.x(), from.y(), from.z());
        if (before <= 0) {
            return 0;
        }
        double area = portal.aperture().widthMetres() * portal.aperture().heightMetres();
        double distance = Math.max(before, from.distance(portal.centre().toVector()) - radius(portal));
        return Math.min(2 * Math.PI, area / (distance * distance));
    }

    private static double radius(Portal portal) {
        return Math.hypot(portal.aperture().widthMetres(), portal.aperture().heightMetres()) / 2;
    }

    /** Returns false if no ray from the word's last exit, or from the lit side of a surface, enters a portal. */
    private boolean mayFollow(int entry) {
        Portal portal = portals.portal(entry);
        Vector3d centre = portal.centre().toVector();
        if (word.isEmpty()) {
            return !(lit instanceof SurfacePoint surface)
                    || surface.faceNormal().dot(centre.sub(surface.place().toVector())) > -radius(portal);
        }
        Portal exit = portals.portal(portals.partner(word.get(word.size() - 1)));
        return exit.inFront(centre.x, centre.y, centre.z) > -radius(portal);
    }

    private void addLights(Vector3dc beyond, double strength, long hash) {
        Portal exit = portals.portal(portals.partner(word.get(word.size() - 1)));
        for (DistantLight far : distant) {
            Vector3d towards = far.towards().toVector();
            if (passes(exit, beyond, towards)) {
                Vector3d irradiance = far.irradiance(exit.centre()).toVector();
                add(beforeWord(towards), Double.POSITIVE_INFINITY, irradiance, strength, hash);
            }
        }
        for (PunctualLight lamp : light.lamps()) {
            Vector3d towards = lamp.position().toVector().sub(beyond);
            double metres = towards.length();
            boolean mayReach = lamp.source().castsShadow() && metres < lamp.rangeMetres();
            if (mayReach && passes(exit, beyond, towards)) {
                add(beforeWord(towards), 1, lamp.irradianceAt(Vec3.of(beyond)), strength, hash);
            }
        }
    }

    /** Returns true if a line from behind the exit leaves through its aperture, and its direction ends in front of it. */
    private static boolean passes(Portal exit, Vector3dc from, Vector3dc direction) {
        double behind = -exit.inFront(from.x(), from.y(), from.z());
        double rate = exit.normal().toVector().dot(direction);
        if (rate <= 0 || behind < 0) {
            return false;
        }
        Vector3d at = new Vector3d(from).fma(behind / rate, direction);
        return exit.aperture().contains(exit.across(at.x, at.y, at.z), exit.upward(at.x, at.y, at.z));
    }

    /** Returns a direction behind the word's portals as it is before them. */
    private Vector3d beforeWord(Vector3dc direction) {
        Vector3d before = new Vector3d(direction);
        for (int i = word.size() - 1; i >= 0; i--) {
            portals.transform(portals.partner(word.get(i))).direction(before);
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
        double passed = 1;
        for (EyePath.Segment segment : path.segments()) {
            passed *= light.passedByClouds(
                    segment.origin().toVector(), segment.direction().toVector(), segment.metres(), random);
        }
        sum.add(lit.reflected(towards.normalize()).mul(irradiance).mul(strength * passed));
    }
}
