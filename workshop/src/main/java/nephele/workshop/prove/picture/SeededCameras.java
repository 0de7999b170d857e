package nephele.workshop.prove.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Camera;
import nephele.engine.level.Level;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.reference.TracedLevel;
import nephele.engine.reference.VisibleSurface;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.lab.bake.TracedPictures;
import org.joml.Vector3d;

/**
 * Views of a level by number: three of five from a reachable place, one within 5 mm of a portal (from a reachable place
 * if there is none), one along a wall. The near plane of none is in a solid, except at portals. A view is determined by
 * the level and the number.
 */
final class SeededCameras {
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final double NEAR_METRES = 0.05;
    private static final double EYE_METRES = 1.65;
    private static final double MAX_WALK_METRES = 12;
    private static final int TRIES = 100;

    private final List<Brush> brushes;
    private final Portals portals;
    private final List<Integer> open = new ArrayList<>();
    private final List<Vec3> starts = new ArrayList<>();
    private final VisibleSurface sight;
    private final double aspect;

    SeededCameras(Level level, TracedLevel traced, double aspect) {
        this.aspect = aspect;
        brushes = level.solids().stream().map(Brush::of).toList();
        portals = Portals.of(level);
        for (int i = 0; i < portals.size(); i++) {
            if (portals.isOpen(i)) {
                open.add(i);
                starts.add(portals.portal(i).world(0, 0, 0.3));
            }
        }
        if (level.player() != null) {
            Vec3 feet = level.player().feet();
            starts.add(new Vec3(feet.x(), feet.y() + EYE_METRES, feet.z()));
        }
        for (Camera camera : level.cameras()) {
            starts.add(camera.position());
        }
        starts.removeIf(this::isInside);
        if (starts.isEmpty()) {
            starts.add(Vec3.ZERO);
        }
        sight = traced.sight(TracedPictures.pinhole(view(Vec3.ZERO, new Vec3(0, 0, -1), Math.PI / 3)));
    }

    View view(int number) {
        var random = new SplittableRandom(number);
        double fov = random.nextInt(4) > 0 ? Math.PI / 3 : Math.toRadians(20 + 100 * random.nextDouble());
        int kind = number % 5;
        if (kind == 3 && !open.isEmpty()) {
            return atPortal(random, fov);
        }
        return kind == 4 ? alongWall(random, fov) : anywhere(random, fov);
    }

    private View anywhere(SplittableRandom random, double fov) {
        View view = fromPlace(random, fov);
        for (int i = 0; i < TRIES && !isWhole(view); i++) {
            view = fromPlace(random, fov);
        }
        return view;
    }

    private View fromPlace(SplittableRandom random, double fov) {
        Vec3 eye = place(random);
        if (random.nextBoolean() && !open.isEmpty()) {
            Portal portal = somePortal(random);
            return view(eye, towards(eye, inAperture(portal, 0, random)), fov);
        }
        return view(eye, direction(random, 0.4), fov);
    }

    /** Returns a view from 5 mm to 5 nm in front of a portal's plane, into it or across it. */
    private View atPortal(SplittableRandom random, double fov) {
        Portal portal = somePortal(random);
        double height = 5e-3 * Math.pow(10, -6 * random.nextDouble());
        Vec3 eye = inAperture(portal, height, random);
        for (int i = 0; i < TRIES && !hasRoom(portal, eye, fov); i++) {
            eye = inAperture(portal, height, random);
        }
        Vec3 n = portal.normal();
        double into = random.nextInt(3) == 0 ? 0.05 : 1;
        Vec3 d = direction(random, 1);
        double along = d.dot(n);
        return view(eye, unit(d.addScaled(-into * Math.abs(along) - along, n)), fov);
    }

    /** Returns a view from 1 mm to 10 cm in front of a visible face, nearly along it. */
    private View alongWall(SplittableRandom random, double fov) {
        for (int i = 0; i < TRIES && !brushes.isEmpty(); i++) {
            List<BrushFace> faces = brushes.get(random.nextInt(brushes.size())).faces();
            BrushFace face = faces.get(random.nextInt(faces.size()));
            Vec3 n = face.plane().normal();
            double height = Math.pow(10, -3 + 2 * random.nextDouble());
            Vec3 eye = onFace(face, random, height);
            Vec3 d = direction(random, 1);
            double out = 0.1 * (2 * random.nextDouble() - 1) - d.dot(n);
            if (!isInside(eye) && isVisible(eye, random)) {
                View view = view(eye, unit(d.addScaled(out, n)), fov);
                if (isWhole(view)) {
                    return view;
                }
            }
        }
        return anywhere(random, fov);
    }

    private static Vec3 onFace(BrushFace face, SplittableRandom random, double height) {
        Vec3 place = face.plane().normal().scaled(height);
        double[] weights =
                random.doubles(face.polygon().size()).map(w -> -Math.log(1 - w)).toArray();
        double all = java.util.Arrays.stream(weights).sum();
        for (int i = 0; i < weights.length; i++) {
            place = place.addScaled(weights[i] / all, face.polygon().get(i));
        }
        return place;
    }

    private boolean isVisible(Vec3 place, SplittableRandom random) {
        Vec3 start = starts.get(random.nextInt(starts.size()));
        Vec3 displacement = place.minus(start);
        return sight.freeMetres(start, towards(start, place)) >= displacement.length() - 1e-6;
    }

    /** Returns the end of two straight walks from a place that is known to be free, without crossing a portal. */
    private Vec3 place(SplittableRandom random) {
        Vec3 place = starts.get(random.nextInt(starts.size()));
        for (int i = 0; i < 2; i++) {
            Vec3 d = direction(random, 0.5);
            double metres = Math.min(sight.freeMetres(place, d), MAX_WALK_METRES) * random.nextDouble();
            Vec3 next = place.addScaled(metres, d);
            place = isInside(next) ? place : next;
        }
        return place;
    }

    /**
     * Returns true if the near plane is in no solid. A player's eye never comes so near to a solid that the near plane
     * shows its inside.
     */
    private boolean isWhole(View view) {
        double width = NEAR_METRES * view.projection().tanHalfWidth();
        double height = NEAR_METRES * view.projection().tanHalfHeight();
        for (int i = 0; i < 25; i++) {
            double x = width * (i % 5 - 2) / 2;
            double y = height * (i / 5 - 2) / 2;
            Vector3d p = view.eye().toVector().fma(-NEAR_METRES, view.back().toVector());
            p.fma(x, view.right().toVector()).fma(y, view.up().toVector());
            if (isInside(Vec3.of(p))) {
                return false;
            }
        }
        return true;
    }

    private boolean isInside(Vec3 p) {
        return brushes.stream().anyMatch(brush -> brush.faces().stream()
                .allMatch(face -> face.plane().signedDistance(p) <= 0));
    }

    private Portal somePortal(SplittableRandom random) {
        return portals.portal(open.get(random.nextInt(open.size())));
    }

    /** Returns true if the near plane is within the opening, and so in no floor or wall behind it. */
    private boolean hasRoom(Portal portal, Vec3 eye, double fov) {
        double metres = NEAR_METRES * Math.tan(fov / 2) * aspect;
        double x = portal.across(eye.x(), eye.y(), eye.z());
        double y = portal.upward(eye.x(), eye.y(), eye.z());
        return portal.aperture().contains(x - metres, y)
                && portal.aperture().contains(x + metres, y)
                && portal.aperture().contains(x, y - metres)
                && portal.aperture().contains(x, y + metres);
    }

    private static Vec3 inAperture(Portal portal, double height, SplittableRandom random) {
        double x = 0;
        double y = 0;
        do {
            x = portal.aperture().widthMetres() * (random.nextDouble() - 0.5);
            y = portal.aperture().heightMetres() * (random.nextDouble() - 0.5);
        } while (!portal.aperture().contains(x, y));
        return portal.world(x, y, height);
    }

    /** @param rise vertical share of the direction; 1 for uniform directions */
    private static Vec3 direction(SplittableRandom random, double rise) {
        double y = rise * (2 * random.nextDouble() - 1);
        double yaw = 2 * Math.PI * random.nextDouble();
        double across = Math.sqrt(1 - y * y);
        return new Vec3(across * StrictMath.cos(yaw), y, across * StrictMath.sin(yaw));
    }

    private static Vec3 towards(Vec3 from, Vec3 to) {
        return unit(to.minus(from));
    }

    private static Vec3 unit(Vec3 v) {
        return v.x() == 0 && v.y() == 0 && v.z() == 0 ? new Vec3(0, 0, -1) : Directions.unit(v);
    }

    private View view(Vec3 eye, Vec3 direction, double fovRadians) {
        Basis basis = Basis.lookAt(eye, eye.addScaled(1, direction), UP, Basis.WORLD);
        Projection projection = new Projection(fovRadians, aspect, NEAR_METRES, Double.POSITIVE_INFINITY);
        return new View(eye, basis.right(), basis.up(), basis.back(), projection);
    }
}
