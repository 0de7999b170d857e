package nephele.editor.document;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.EntitySection;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** Finds the entities of a level along a ray, and in a region. Hidden entities are never found. */
public final class Picker {
    public static final String SOLIDS = "solids";
    private static final double ON_PLANE_METRES = 1e-7;

    private final Level level;
    private final LevelShapes shapes;
    private final Set<String> hidden;
    private final Set<String> locked;

    /** Creates a picker of a snapshot. */
    public Picker(Level level, LevelShapes shapes) {
        this.level = level;
        this.shapes = shapes;
        hidden = new HashSet<>(level.editor().hidden());
        locked = new HashSet<>(level.editor().locked());
    }

    /** Returns the entities that can be selected along a ray, the nearest first. */
    public List<Pick> along(Ray ray) {
        List<Pick> picks = all(ray);
        picks.removeIf(pick -> locked.contains(pick.entity().text()));
        return picks;
    }

    /** Returns the visible surfaces of solids along a ray, those of locked ones too, the nearest first. */
    public List<Pick> surfaces(Ray ray) {
        List<Pick> picks = all(ray);
        picks.removeIf(pick -> pick.face().isEmpty());
        return picks;
    }

    private List<Pick> all(Ray ray) {
        List<Pick> picks = new ArrayList<>();
        for (Brush brush : shapes.brushes()) {
            EntityRef ref = new EntityRef(SOLIDS, brush.solidId());
            if (!hidden.contains(ref.text())
                    && ray.boxEntry(brush.shape().bounds(), Double.MAX_VALUE) < Double.POSITIVE_INFINITY) {
                addBrush(picks, ray, ref, brush);
            }
        }
        for (EntityRef ref : symbols()) {
            addBox(picks, ray, ref);
        }
        picks.sort(Comparator.comparingDouble(Pick::distanceMetres));
        return picks;
    }

    /** Returns the visible entities other than solids. */
    private List<EntityRef> symbols() {
        List<EntityRef> refs = new ArrayList<>();
        for (EntitySection section : Entities.LEVEL.lists()) {
            if (!section.path().equals(SOLIDS)) {
                for (Record entity : section.entities(level)) {
                    refs.add(new EntityRef(section.path(), RecordKind.id(entity)));
                }
            }
        }
        if (level.player() != null) {
            refs.add(EntityRef.single("player"));
        }
        refs.removeIf(ref -> hidden.contains(ref.text()));
        return refs;
    }

    private static void addBrush(List<Pick> picks, Ray ray, EntityRef ref, Brush brush) {
        double enter = 0;
        double leave = Double.POSITIVE_INFINITY;
        int face = -1;
        Vec3 origin = new Vec3(ray.originX(), ray.originY(), ray.originZ());
        Vec3 direction = new Vec3(ray.directionX(), ray.directionY(), ray.directionZ());
        List<Brush.BrushFace> faces = brush.faces();
        for (int i = 0; i < faces.size(); i++) {
            Plane plane = faces.get(i).plane();
            double height = plane.signedDistance(origin);
            double rate = plane.normal().dot(direction);
            if (rate < 0 && -height / rate > enter) {
                enter = -height / rate;
                face = i;
            } else if (rate > 0) {
                leave = Math.min(leave, -height / rate);
            } else if (rate == 0 && height > ON_PLANE_METRES) {
                return;
            }
        }
        if (face >= 0 && enter <= leave) {
            Brush.BrushFace hit = faces.get(face);
            picks.add(
                    new Pick(ref, hit.name(), enter, ray.at(enter), hit.plane().normal()));
        }
    }

    private void addBox(List<Pick> picks, Ray ray, EntityRef ref) {
        Aabb box = EntityBounds.of(level, ref);
        if (box.isEmpty() || contains(box, new Vec3(ray.originX(), ray.originY(), ray.originZ()))) {
            return;
        }
        double enter = ray.boxEntry(box, Double.MAX_VALUE);
        if (enter < Double.POSITIVE_INFINITY) {
            picks.add(new Pick(ref, "", enter, ray.at(enter), new Vec3(0, 1, 0)));
        }
    }

    /** Returns the selectable entities whose boxes a region touches. */
    public List<EntityRef> touching(Aabb region) {
        return in(shape -> region.overlaps(shape.bounds()), region::overlaps);
    }

    /** Returns the selectable entities that are wholly inside a region. */
    public List<EntityRef> inside(Aabb region) {
        return in(
                shape -> shape.vertices().stream().allMatch(vertex -> contains(region, vertex)),
                box -> contains(region, box));
    }

    private List<EntityRef> in(Predicate<ConvexPolyhedron> holdsSolid, Predicate<Aabb> holdsBox) {
        List<EntityRef> found = new ArrayList<>();
        for (Brush brush : shapes.brushes()) {
            EntityRef ref = new EntityRef(SOLIDS, brush.solidId());
            boolean isFree = !hidden.contains(ref.text()) && !locked.contains(ref.text());
            if (isFree && holdsSolid.test(brush.shape())) {
                found.add(ref);
            }
        }
        for (EntityRef ref : symbols()) {
            Aabb box = EntityBounds.of(level, ref);
            if (!box.isEmpty() && holdsBox.test(box) && !locked.contains(ref.text())) {
                found.add(ref);
            }
        }
        return found;
    }

    private static boolean contains(Aabb box, Vec3 p) {
        return p.x() >= box.minX() - ON_PLANE_METRES
                && p.x() <= box.maxX() + ON_PLANE_METRES
                && p.y() >= box.minY() - ON_PLANE_METRES
                && p.y() <= box.maxY() + ON_PLANE_METRES
                && p.z() >= box.minZ() - ON_PLANE_METRES
                && p.z() <= box.maxZ() + ON_PLANE_METRES;
    }

    private static boolean contains(Aabb outer, Aabb inner) {
        return contains(outer, new Vec3(inner.minX(), inner.minY(), inner.minZ()))
                && contains(outer, new Vec3(inner.maxX(), inner.maxY(), inner.maxZ()));
    }

    /**
     * Something that a ray meets.
     *
     * @param face name of the face of a solid; empty for other entities
     * @param distanceMetres along the ray
     * @param normal outward, unit length
     */
    public record Pick(EntityRef entity, String face, double distanceMetres, Vec3 point, Vec3 normal) {}
}
