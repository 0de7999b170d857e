package nephele.scenes.xml;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.scenes.xml.LevelDraft.Part;
import nephele.scenes.xml.XmlGroup.Step;
import nephele.scenes.xml.XmlScene.XmlWarning;
import org.joml.AxisAngle4d;
import org.joml.Matrix4d;
import org.joml.Quaterniond;

/**
 * Converts groups to placements: the first model of a group carries its frame, and the other models and the subgroups
 * have it as parent. A group without models passes its steps on.
 */
final class DraftPlacements {
    private static final int MOST_STEPS = 1000;
    private static final int MOST_MODELS = 10_000;

    private final List<Part> parts;
    private final DraftLooks looks;
    private final List<XmlWarning> warnings;
    private final List<ModelPlacement> placed = new ArrayList<>();
    private final List<Integer> numbers = new ArrayList<>();
    private int next;

    /**
     * A group in the queue. @param steps from {@code parent}'s frame; {@code null} if it is left out with its content
     */
    private record Waiting(XmlGroup group, String parent, List<TransformStep> steps) {}

    private DraftPlacements(List<Part> parts, DraftLooks looks, List<XmlWarning> warnings) {
        this.parts = parts;
        this.looks = looks;
        this.warnings = warnings;
    }

    static DraftPlacements of(XmlScene scene, List<Part> parts, DraftLooks looks, List<XmlWarning> warnings) {
        DraftPlacements placements = new DraftPlacements(parts, looks, warnings);
        placements.place(scene.root());
        return placements;
    }

    /** Places the groups in the order of {@link PosedScene}. */
    private void place(XmlGroup root) {
        List<Waiting> waiting = new ArrayList<>();
        waiting.add(new Waiting(root, null, List.of()));
        while (!waiting.isEmpty()) {
            Waiting group = waiting.remove(waiting.size() - 1);
            List<TransformStep> steps = group.steps == null ? null : withOwn(group);
            Waiting below = placeModels(new Waiting(group.group, group.parent, steps));
            List<XmlGroup> groups = group.group.groups();
            for (int i = groups.size() - 1; i >= 0; i--) {
                waiting.add(new Waiting(groups.get(i), below.parent, below.steps));
            }
        }
        if (placed.size() == MOST_MODELS) {
            warn(root.line(), "a level places at most " + MOST_MODELS + " models: the others are left out");
        }
    }

    /**
     * Places a group's models.
     *
     * @return the state with which its subgroups begin
     */
    private Waiting placeModels(Waiting group) {
        String parent = group.parent;
        List<TransformStep> steps = group.steps;
        for (XmlModel model : group.group.models()) {
            Part part = parts.get(next);
            if (part != null && steps != null && placed.size() < MOST_MODELS) {
                String id = "model-" + (next + 1);
                String material = looks.of(model.colours(), part);
                placed.add(new ModelPlacement(id, part.file(), parent, steps, material, false));
                numbers.add(next);
                if (!steps.isEmpty() || parent == null) {
                    parent = id;
                    steps = List.of();
                }
            }
            next++;
        }
        return new Waiting(group.group, parent, steps);
    }

    /**
     * Returns the steps with the group's own.
     *
     * @return {@code null} if a level cannot hold them
     */
    private List<TransformStep> withOwn(Waiting group) {
        int line = group.group.line();
        List<TransformStep> steps = new ArrayList<>(group.steps);
        boolean moves = false;
        for (Step step : group.group.steps()) {
            moves |= step instanceof Step.Follow || step instanceof Step.Spin;
            if (!add(step, steps)) {
                warn(line, "its scale is flat or beyond what a level holds: the group is left out");
                return null;
            }
        }
        if (moves) {
            warn(line, "a level's models stay: the group stands where it is at time 0");
        }
        if (steps.size() > MOST_STEPS) {
            warn(line, "more than " + MOST_STEPS + " steps without a model between: the group is left out");
            return null;
        }
        return steps;
    }

    private static boolean add(Step step, List<TransformStep> steps) {
        if (step instanceof Step.Translate translate) {
            steps.add(new TransformStep.Translate(translate.by()));
            return isWithin(translate.by(), 0, 1e7);
        } else if (step instanceof Step.Scale scale) {
            steps.add(new TransformStep.Scale(scale.by()));
            return isWithin(scale.by(), 1e-6, 1e7);
        } else if (step instanceof Step.Rotate rotate) {
            Vec3 axis = rotate.axis();
            Vec3 unit = Directions.unit(axis);
            if (unit != null) {
                steps.add(new TransformStep.Rotate(unit, rotate.angleDegrees() % 360));
            }
        } else if (step instanceof Step.Follow follow) {
            steps.add(new TransformStep.Translate(follow.points().get(0)));
            TransformStep turn = turn(follow);
            if (turn != null) {
                steps.add(turn);
            }
            return isWithin(follow.points().get(0), 0, 1e7);
        }
        return true;
    }

    private static boolean isWithin(Vec3 v, double least, double most) {
        double smallest = Math.min(Math.abs(v.x()), Math.min(Math.abs(v.y()), Math.abs(v.z())));
        double largest = Math.max(Math.abs(v.x()), Math.max(Math.abs(v.y()), Math.abs(v.z())));
        return smallest >= least && largest <= most;
    }

    private void warn(int line, String message) {
        warnings.add(new XmlWarning(line, message));
    }

    List<ModelPlacement> placed() {
        return List.copyOf(placed);
    }

    /** Returns the numbers of the placed models in {@link PosedScene}. */
    List<Integer> numbers() {
        return numbers;
    }

    /**
     * Returns the rotation of a path.
     *
     * @return {@code null} for none
     */
    private static TransformStep turn(Step.Follow follow) {
        if (!follow.align()) {
            return null;
        }
        Matrix4d frame = new Matrix4d();
        new CurveFrame(follow.points()).carryAligned(0, frame, new Matrix4d());
        AxisAngle4d turn = new AxisAngle4d(frame.getNormalizedRotation(new Quaterniond()));
        boolean turns = turn.angle != 0 && Double.isFinite(turn.angle + turn.x + turn.y + turn.z);
        return turns ? new TransformStep.Rotate(new Vec3(turn.x, turn.y, turn.z), Math.toDegrees(turn.angle)) : null;
    }
}
