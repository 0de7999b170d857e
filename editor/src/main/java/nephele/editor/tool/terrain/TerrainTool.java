package nephele.editor.tool.terrain;

import java.util.List;
import java.util.Optional;
import nephele.editor.mark.Mark;
import nephele.editor.terrain.LayerChoice;
import nephele.editor.terrain.NumberWords;
import nephele.editor.terrain.TerrainBrush;
import nephele.editor.terrain.TerrainBrush.Effect;
import nephele.editor.terrain.TerrainPainting;
import nephele.editor.terrain.TerrainRefusal;
import nephele.editor.terrain.TerrainSight;
import nephele.editor.terrain.TerrainSight.Hit;
import nephele.editor.terrain.TerrainText;
import nephele.editor.text.Words;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Terrain;
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
            "terrain",
            TerrainTool::new);

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
        sight = new TerrainSight(context.aside());
        painting = new TerrainPainting(context.document(), context.maps(), context.aside());
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
        } catch (TerrainRefusal refusal) {
            context.status(refusal.told());
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
        } catch (TerrainRefusal refusal) {
            context.status(refusal.told());
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
        return BrushRing.around(hovered.point().x(), hovered.point().z(), radius, this::y);
    }

    /** Returns the world y of the heights that are shown. */
    private double y(double x, double z) {
        double y = HeightFieldSurface.y(hovered.field(), x, z);
        return Double.isNaN(y) ? y : painting.y(x, z).orElse(y);
    }

    @Override
    public Words hint() {
        if (hovered == null) {
            return ENTRY.description();
        }
        TerrainBrush shown = context.options().terrainBrush().with(brush.effect());
        if (shown.effect().isPaint()) {
            return TerrainText.PAINT_BRUSH.with(
                    title(shown, hovered.terrain()),
                    NumberWords.of(shown.radiusMetres()),
                    Math.round(100 * shown.strength()));
        }
        return TerrainText.BRUSH.with(
                shown.effect().title(),
                NumberWords.of(shown.radiusMetres()),
                Math.round(100 * shown.strength()),
                NumberWords.of(y(hovered.point().x(), hovered.point().z())
                        - hovered.terrain().centre().y()));
    }

    private static Words title(TerrainBrush shown, Terrain said) {
        return shown.effect() == Effect.PAINT
                ? TerrainText.PAINT.with(LayerChoice.name(said, shown.layer()))
                : shown.effect().title();
    }
}
