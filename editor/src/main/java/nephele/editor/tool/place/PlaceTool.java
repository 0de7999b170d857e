package nephele.editor.tool.place;

import java.util.List;
import java.util.Optional;
import nephele.editor.document.EntityBounds;
import nephele.editor.document.Snapshot;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.text.EntityWords;
import nephele.editor.text.Words;
import nephele.editor.tool.PointedPlace;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * Places an entity of the kind that the options name, standing on the surface under the pointer, snapped to the grid
 * along it. A single record, such as the player's start, replaces the level's.
 */
public final class PlaceTool implements Tool {
    public static final ToolEntry ENTRY = new ToolEntry(
            "place",
            Words.of("Place", "Colocar", "Colocar"),
            Words.of(
                    "Click on a surface to place an entity there",
                    "Clique numa superfície para colocar uma entidade",
                    "Clica numa superfície para colocar uma entidade"),
            "G",
            PlaceTool::new);

    private static final Words PLACE = Words.of("Place %s", "Colocar %s", "Colocar %s");
    private static final Words HINT = Words.of(
            "%s: click to place it; hold the button to move it first",
            "%s: clique para colocar; segure o botão para mover antes",
            "%s: clica para colocar; mantém o botão premido para mover antes");
    private static final Words UNKNOWN = Words.of(
            "There is nothing of the kind %s in %s: choose another kind",
            "Não há nada do tipo %s em %s: escolha outro tipo", "Não há nada do tipo %s em %s: escolhe outro tipo");

    private final ToolContext context;
    /** The entity that a click would place; {@code null} while the pointer is over nothing. */
    private NewEntity ghost;

    private boolean isPressed;

    public PlaceTool(ToolContext context) {
        this.context = context;
    }

    @Override
    public void moved(Pointer pointer) {
        ghost = at(pointer).orElse(null);
    }

    @Override
    public void left() {
        ghost = null;
    }

    @Override
    public void pressed(Pointer pointer) {
        isPressed = true;
        ghost = null;
        dragged(pointer);
        if (ghost == null) {
            context.status(hint());
        }
    }

    @Override
    public void dragged(Pointer pointer) {
        if (!isPressed) {
            return;
        }
        at(pointer).ifPresent(entity -> {
            ghost = entity;
            context.document().drag(before -> entity.addedTo(before));
        });
    }

    private Optional<NewEntity> at(Pointer pointer) {
        Snapshot before = context.document().history().current();
        return PointedPlace.under(
                        context,
                        pointer,
                        entity -> isPressed && ghost != null && ghost.ref().equals(entity))
                .flatMap(place -> NewEntity.of(before.level(), context.options(), place.snapped(context, pointer)));
    }

    @Override
    public void released(Pointer pointer) {
        if (isPressed && ghost != null) {
            context.document().commitDrag(PLACE.with(ghost.ref().shortName()));
        }
        isPressed = false;
        ghost = null;
    }

    @Override
    public void cancel() {
        context.document().cancelDrag();
        isPressed = false;
        ghost = null;
    }

    @Override
    public List<Mark> marks() {
        Aabb box = ghost == null ? Aabb.EMPTY : EntityBounds.of(ghost.entity());
        return box.isEmpty() ? List.of() : Mark.box(box, MarkColour.PREVIEW, Mark.Visibility.ALWAYS);
    }

    @Override
    public Words hint() {
        Snapshot now = context.document().now();
        PointedPlace anywhere = new PointedPlace(Vec3.ZERO, new Vec3(0, 1, 0));
        return NewEntity.of(now.level(), context.options(), anywhere)
                .map(entity -> HINT.with(EntityWords.ofKind(
                        context.options().section(), context.options().kind())))
                .orElseGet(() ->
                        UNKNOWN.with(context.options().kind(), context.options().section()));
    }
}
