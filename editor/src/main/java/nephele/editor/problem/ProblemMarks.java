package nephele.editor.problem;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.editor.document.EntityBounds;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;

/** Marks of problems: a line, the area of faces, the edges of a solid, the box of an entity. */
final class ProblemMarks {
    private ProblemMarks() {}

    static List<Mark> of(Level level, Problem problem) {
        List<Vec3> place = problem.subject().place();
        if (!place.isEmpty()) {
            return problem.subject().topic() == Topic.LEAK ? line(place) : area(place);
        }
        Optional<EntityPath> path = EntityPath.of(level, problem.path());
        if (path.isPresent()) {
            return of(level, path.get());
        }
        return problem.path().startsWith("player") && level.player() != null
                ? edges(EntityBounds.of(level.player()))
                : List.of();
    }

    private static List<Mark> of(Level level, EntityPath path) {
        if (path.entity(level) instanceof Solid solid) {
            try {
                Optional<BrushFace> face = path.derivedFace(level);
                return face.isPresent()
                        ? area(face.get().polygon())
                        : edges(Brush.of(solid).shape());
            } catch (IllegalArgumentException withoutVolume) {
                return solid instanceof Solid.Box box ? edges(Aabb.around(box.centre(), box.size())) : List.of();
            }
        }
        Aabb box = EntityBounds.of(path.entity(level));
        return box.isEmpty() ? List.of() : edges(box);
    }

    static List<Mark> line(List<Vec3> points) {
        List<Mark> marks = new ArrayList<>();
        for (int i = 1; i < points.size(); i++) {
            marks.add(line(points.get(i - 1), points.get(i)));
        }
        return marks;
    }

    private static List<Mark> area(List<Vec3> corners) {
        List<Mark> marks = new ArrayList<>();
        marks.add(new Mark.Polygon(corners, MarkColour.PROBLEM, Mark.Visibility.ALWAYS));
        marks.addAll(Mark.polygon(corners, MarkColour.PROBLEM, Mark.Visibility.ALWAYS));
        return marks;
    }

    private static List<Mark> edges(Aabb box) {
        return Mark.box(box, MarkColour.PROBLEM, Mark.Visibility.ALWAYS);
    }

    private static List<Mark> edges(ConvexPolyhedron shape) {
        List<Mark> marks = new ArrayList<>();
        for (ConvexPolyhedron.Face face : shape.faces()) {
            for (int i = 0; i < face.polygon().size(); i++) {
                Vec3 from = face.polygon().get(i);
                Vec3 to = face.polygon().get((i + 1) % face.polygon().size());
                if (isFirst(from, to)) {
                    marks.add(line(from, to));
                }
            }
        }
        return marks;
    }

    /** Picks one of the two senses in which the faces beside an edge run along it. */
    private static boolean isFirst(Vec3 from, Vec3 to) {
        int order = Double.compare(from.x(), to.x());
        order = order != 0 ? order : Double.compare(from.y(), to.y());
        return (order != 0 ? order : Double.compare(from.z(), to.z())) < 0;
    }

    private static Mark line(Vec3 from, Vec3 to) {
        return new Mark.Line(from, to, MarkColour.PROBLEM, Mark.Visibility.ALWAYS);
    }
}
