package nephele.editor.window.dialog;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import nephele.editor.document.Document;
import nephele.editor.document.Grid;
import nephele.editor.panel.model.InspectorField;
import nephele.editor.panel.model.InspectorModel;
import nephele.editor.panel.model.NumberExpression;
import nephele.editor.panel.model.PanelText;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.FieldKind;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Words;
import nephele.editor.window.dialog.FormField.Option;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;

/**
 * A form that asks for the parameters of an action.
 *
 * @param part the name by which the window shows it; that of the action if it replaces its use without parameters
 * @param action id of the action that it runs
 * @param check returns what is wrong with some values beyond their grammar, or {@link Words#NONE}
 */
record ActionForm(
        String part,
        String action,
        Words title,
        List<FormField> fields,
        BiFunction<EditorSession, Map<String, String>, Words> check) {
    private static final InspectorModel MODEL = new InspectorModel(Entities.LEVEL);

    /** The forms of all actions that need values. */
    static final List<ActionForm> ALL = List.of(
            of("rename", DialogText.RENAME, FormField.text("id", DialogText.NEW_ID, ActionForm::mainId))
                    .withCheck(ActionForm::idProblem),
            of("move", DialogText.MOVE, FormField.vector("by", DialogText.MOVE_BY, any -> "0,0,0")),
            of(
                            "turn",
                            DialogText.TURN,
                            FormField.choice("axis", DialogText.AXIS, any -> axes()),
                            FormField.number("degrees", DialogText.DEGREES, any -> "90"))
                    .withPart("turn-by"),
            of("scale", DialogText.SCALE, FormField.vector("by", DialogText.FACTORS, any -> "1,1,1")),
            of(
                            "set",
                            DialogText.SET,
                            FormField.choice("value", DialogText.FIELD, ActionForm::settable),
                            FormField.text("to", DialogText.VALUE, any -> ""))
                    .withCheck(ActionForm::referenceProblem),
            of(
                    "brush",
                    DialogText.DRAW,
                    FormField.choice("shape", DialogText.SHAPE, any -> shapes()),
                    FormField.vector("min", DialogText.FIRST_CORNER, any -> "0,0,0"),
                    FormField.vector("max", DialogText.SECOND_CORNER, ActionForm::secondCorner)),
            of(
                            "camera",
                            DialogText.GO_TO,
                            FormField.vector("at", DialogText.PLACE, ActionForm::place),
                            FormField.number(
                                    "yaw",
                                    DialogText.YAW,
                                    session -> number(session.panes()
                                            .activeView()
                                            .perspective()
                                            .yawDegrees())),
                            FormField.number(
                                    "pitch",
                                    DialogText.PITCH,
                                    session -> number(session.panes()
                                            .activeView()
                                            .perspective()
                                            .pitchDegrees())))
                    .withPart("coordinates"),
            of("grid", DialogText.GRID, FormField.choice("metres", DialogText.GRID_STEP, ActionForm::steps)));

    private static ActionForm of(String action, DialogText title, FormField... fields) {
        return new ActionForm(action, action, title.words(), List.of(fields), (session, values) -> Words.NONE);
    }

    private ActionForm withPart(String otherPart) {
        return new ActionForm(otherPart, action, title, fields, check);
    }

    private ActionForm withCheck(BiFunction<EditorSession, Map<String, String>, Words> other) {
        return new ActionForm(part, action, title, fields, other);
    }

    private static List<EntityRef> selected(EditorSession session) {
        return session.document().selection().entities();
    }

    private static String mainId(EditorSession session) {
        List<EntityRef> refs = selected(session);
        return refs.isEmpty() ? "" : refs.get(0).id();
    }

    private static Words idProblem(EditorSession session, Map<String, String> values) {
        Document document = session.document();
        Optional<InspectorField> field = MODEL.fields(document.level(), selected(session)).stream()
                .filter(InspectorField::isId)
                .findFirst();
        return field.flatMap(id -> MODEL.problem(document.level(), selected(session), id, values.get("id")))
                .orElse(Words.NONE);
    }

    /** Tells of a reference to what the level has not; the action itself takes any text. */
    private static Words referenceProblem(EditorSession session, Map<String, String> values) {
        Level level = session.document().level();
        String wanted = values.get("to");
        return MODEL.fields(level, selected(session)).stream()
                .filter(field -> field.type().kind() == FieldKind.REFERENCE)
                .filter(field -> field.type().field().name().equals(values.get("value")))
                .map(field -> MODEL.ids(level, field.type().refersTo()))
                .filter(ids -> !ids.contains(wanted))
                .map(ids -> ids.isEmpty()
                        ? DialogText.NONE_THERE.with(wanted)
                        : DialogText.NO_SUCH.with(wanted, String.join(", ", ids)))
                .findFirst()
                .orElse(Words.NONE);
    }

    private static List<Option> axes() {
        return List.of(
                new Option("0,1,0", Words.of("y (up)", "y (para cima)", "y (para cima)")),
                new Option("1,0,0", Words.same("x")),
                new Option("0,0,1", Words.same("z")));
    }

    private static List<Option> shapes() {
        return List.of(
                new Option("box", PanelText.BOX.words()),
                new Option("wedge", PanelText.WEDGE.words()),
                new Option("stairs", PanelText.STAIRS.words()),
                new Option("arch", PanelText.ARCH.words()),
                new Option("cylinder", PanelText.CYLINDER.words()),
                new Option("room", PanelText.ROOM.words()));
    }

    /** Returns the plain fields of what is selected, by their words. */
    private static List<Option> settable(EditorSession session) {
        Map<String, Option> options = new LinkedHashMap<>();
        for (InspectorField field : MODEL.fields(session.document().level(), selected(session))) {
            boolean isPlain = field.path().steps().size() == 1 && !field.isHeading() && !field.isId();
            if (isPlain) {
                String name = field.type().field().name();
                options.putIfAbsent(name, new Option(name, field.words()));
            }
        }
        return List.copyOf(options.values());
    }

    private static List<Option> steps(EditorSession session) {
        List<Option> steps = new ArrayList<>();
        for (double metres = Grid.FINEST_METRES; metres <= Grid.COARSEST_METRES; metres *= 2) {
            Option step = new Option(number(metres), Words.same(number(metres) + " m"));
            // The step in use comes first, so that it is the chosen one.
            steps.add(metres == session.grid().stepMetres() ? 0 : steps.size(), step);
        }
        return List.copyOf(steps);
    }

    private static String secondCorner(EditorSession session) {
        String side = number(2 * session.grid().stepMetres());
        return side + "," + side + "," + side;
    }

    private static String place(EditorSession session) {
        Vec3 at = session.panes().activeView().perspective().eye();
        return number(at.x()) + "," + number(at.y()) + "," + number(at.z());
    }

    private static String number(double value) {
        return NumberExpression.text(Math.round(value * 1000) / 1000.0);
    }
}
