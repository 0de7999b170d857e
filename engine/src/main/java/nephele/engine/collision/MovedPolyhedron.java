package nephele.engine.collision;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Passage;

/** A convex solid mapped through a portal. */
final class MovedPolyhedron {
    private MovedPolyhedron() {}

    static ConvexPolyhedron through(Passage passage, ConvexPolyhedron solid) {
        List<ConvexPolyhedron.Face> faces = new ArrayList<>();
        for (ConvexPolyhedron.Face face : solid.faces()) {
            List<Vec3> polygon = face.polygon().stream().map(passage::point).toList();
            Vec3 normal = passage.direction(face.plane().normal());
            faces.add(new ConvexPolyhedron.Face(face.planeIndex(), Cave.through(normal, polygon.get(0)), polygon));
        }
        List<Vec3> corners = solid.vertices().stream().map(passage::point).toList();
        return new ConvexPolyhedron(List.copyOf(faces), corners, Aabb.of(corners));
    }
}
