package nephele.editor.tool.terrain;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.editor.pane.Mark;
import nephele.editor.pane.Mark.Visibility;
import nephele.editor.pane.MarkColour;
import nephele.editor.terrain.LayerChoice;
import nephele.editor.terrain.TerrainBrush;
import nephele.editor.terrain.TerrainBrush.Effect;
import nephele.editor.terrain.TerrainPainting;
import nephele.editor.terrain.TerrainSight;
import nephele.editor.terrain.TerrainSight.Hit;
import nephele.editor.terrain.TerrainText;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Terrain;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightFieldSurface;

/** Paints heights or layers with a round brush: a drag is one stroke. */
public final class TerrainTool implements Tool {
    public static final ToolEntry ENTRY = new ToolEntry(
            "terrain",
            Words.of("Terrain", "Terreno", "Terreno"),
            Words.of(
                    "Drag over a terrain to shape or paint it; Shift lowers or erases",
                    "Arraste sobre um terreno para moldá-lo ou pintá-lo; Shift rebaixa ou apaga",
                    "Arrasta sobre um terreno para o moldar ou pintar; Shift rebaixa ou apaga"),
            "T",
            TerrainTool::new);
    private static final int RING_CORNERS = 64;
    /** Height of the outline above the ground, so that the ground does not hide it. */
    private static final double LIFT_PER_RADIUS = 0.01;

    private final ToolContext context;
    private final TerrainPainting painting;
    private final TerrainSight sight;
    /** The place under the pointer; {@code null} over no terrain. */
    private Hit hovered;
    /** The terrain as it was when the stroke began: a place under the pointer does not move by the stroke itself. */
    private Hit pressed;

    private TerrainBrush brush;

    public TerrainTool(ToolContext context) {
        this.context = context;
        sight = new TerrainSight(context.background());
        painting = new TerrainPainting(context.document(), context.maps(), context.background());
        brush = context.options().terrainBrush();
    }

    @Override
    public void moved(Pointer pointer) {
        brush = brush(pointer);
        hovered = under(pointer).orElse(null);
    }

    private TerrainBrush brush(Pointer pointer) {
        TerrainBrush chosen = context.options().terrainBrush();
        return pointer.isHeld(Modifier.SHIFT) ? chosen.with(chosen.effect().inverted()) : chosen;
    }

    private Optional<Hit> under(Pointer pointer) {
        Optional<AssetSource> assets = context.assets();
        return assets.flatMap(
                files -> sight.along(pointer.ray(), context.document().level(), files));
    }

    @Override
    public void left() {
        hovered = null;
    }

    @Override
    public void pressed(Pointer pointer) {
        moved(pointer);
        if (hovered == null) {
            context.status(TerrainText.NO_TERRAIN.words());
            return;
        }
        try {
            painting.begin(
                    hovered.terrain(),
                    context.assets().orElseThrow(),
                    brush,
                    hovered.point().x(),
                    hovered.point().z());
            pressed = hovered;
            painting.notice().ifPresent(context::status);
        } catch (EditorRefusal refusal) {
            context.status(refusal.words());
        }
    }

    @Override
    public void dragged(Pointer pointer) {
        if (pressed == null) {
            return;
        }
        hovered = pressed.under(pointer.ray()).orElse(null);
        if (hovered != null) {
            painting.to(hovered.point().x(), hovered.point().z());
            painting.notice().ifPresent(context::status);
        }
    }

    @Override
    public void released(Pointer pointer) {
        pressed = null;
        try {
            painting.end().ifPresent(context::status);
        } catch (EditorRefusal refusal) {
            context.status(refusal.words());
        }
        moved(pointer);
    }

    @Override
    public void cancel() {
        painting.cancel();
        context.document().cancelDrag();
        pressed = null;
        hovered = null;
    }

    @Override
    public List<Mark> marks() {
        if (hovered == null) {
            return List.of();
        }
        double radius = context.options().terrainBrush().radiusMetres();
        return ring(hovered.point().x(), hovered.point().z(), radius);
    }

    /** Returns the world y of the visible ground; NaN beside the terrain. */
    private double y(double x, double z) {
        double y = HeightFieldSurface.y(hovered.field(), x, z);
        return Double.isNaN(y) ? y : painting.y(x, z).orElse(y);
    }

    @Override
    public Words hint() {
        if (hovered == null) {
            return ENTRY.description();
        }
        TerrainBrush active = context.options().terrainBrush().with(brush.effect());
        if (active.effect().isPaint()) {
            return TerrainText.PAINT_BRUSH.with(
                    title(active, hovered.terrain()),
                    TerrainText.number(active.radiusMetres()),
                    Math.round(100 * active.strength()));
        }
        return TerrainText.BRUSH.with(
                active.effect().title(),
                TerrainText.number(active.radiusMetres()),
                Math.round(100 * active.strength()),
                TerrainText.number(y(hovered.point().x(), hovered.point().z())
                        - hovered.terrain().centre().y()));
    }

    private static Words title(TerrainBrush active, Terrain terrain) {
        return active.effect() == Effect.PAINT
                ? TerrainText.PAINT.with(LayerChoice.name(terrain, active.layer()))
                : active.effect().title();
    }

    /** Returns the outline and the middle of a brush on the ground; parts beside the terrain are left out. */
    private List<Mark> ring(double x, double z, double radius) {
        List<Mark> marks = new ArrayList<>();
        Vec3 previous = corner(x, z, radius, 0);
        for (int i = 1; i <= RING_CORNERS; i++) {
            Vec3 next = corner(x, z, radius, i);
            if (!Double.isNaN(previous.y() + next.y())) {
                marks.add(new Mark.Line(previous, next, MarkColour.PREVIEW, Visibility.ALWAYS));
            }
            previous = next;
        }
        marks.add(new Mark.Handle(new Vec3(x, y(x, z), z), MarkColour.PREVIEW));
        return marks;
    }

    private Vec3 corner(double middleX, double middleZ, double radius, int number) {
        double angle = 2 * Math.PI * number / RING_CORNERS;
        double x = middleX + radius * Math.cos(angle);
        double z = middleZ + radius * Math.sin(angle);
        return new Vec3(x, y(x, z) + LIFT_PER_RADIUS * radius, z);
    }
}
