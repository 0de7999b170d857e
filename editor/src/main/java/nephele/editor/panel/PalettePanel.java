package nephele.editor.panel;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Font;
import java.util.ArrayList;
import java.util.List;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.SwingConstants;
import nephele.editor.brush.ShapeOptions;
import nephele.editor.panel.model.PaletteModel;
import nephele.editor.panel.model.PanelText;
import nephele.editor.record.LevelStructure;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionListener.Change;
import nephele.editor.toolbox.Tools;
import nephele.engine.level.Material;
import net.miginfocom.swing.MigLayout;

/** Buttons for brush shapes, kinds of entities and materials; they set what the tools make next. */
public final class PalettePanel extends JPanel {
    private final transient EditorSession session;
    private final JPanel content =
            new WidthTrackingPanel(new MigLayout("insets 4, gap 3, fillx, wrap 2", "[grow, fill, sg][grow, fill, sg]"));
    private transient List<Material> shown = List.of();

    public PalettePanel(EditorSession session) {
        super(new MigLayout("insets 4, fill", "[grow, fill]", "[grow, fill]"));
        this.session = session;
        add(new JScrollPane(content));
        session.listen(change -> {
            boolean isOther = session.document().level().materials() != shown;
            if (change == Change.SETTINGS || (change == Change.DOCUMENT || change == Change.FILE) && isOther) {
                refresh();
            }
        });
        refresh();
    }

    private void refresh() {
        shown = session.document().level().materials();
        getAccessibleContext().setAccessibleName(PanelText.PALETTE.in(session.language()));
        content.removeAll();
        heading(PanelText.SHAPES);
        shape(PanelText.BOX, new ShapeOptions.Box());
        shape(PanelText.WEDGE, new ShapeOptions.Wedge(null));
        shape(PanelText.STAIRS, new ShapeOptions.Stairs(null, 8));
        shape(PanelText.ARCH, new ShapeOptions.Arch(12, 0.5));
        shape(PanelText.CYLINDER, new ShapeOptions.Cylinder(16));
        shape(PanelText.ROOM, new ShapeOptions.Room(0.5));
        heading(PanelText.ENTITIES);
        for (PaletteModel.Entry entry : PaletteModel.entries(LevelStructure.LEVEL)) {
            button(entry.words().in(session.language()), null, () -> {
                session.options().entity(entry.section(), entry.kind());
                take("place");
            });
        }
        heading(PanelText.MATERIALS);
        List<Material> materials = new ArrayList<>(List.of(Material.DEFAULT_GREY));
        materials.addAll(shown);
        for (Material material : materials) {
            boolean isGrey = material == Material.DEFAULT_GREY;
            button(
                    isGrey ? PanelText.GREY.in(session.language()) : material.id(),
                    PanelIcon.swatch(LinearColour.shown(material.baseColour())),
                    () -> {
                        session.options().material(isGrey ? null : material.id());
                        session.tell(Change.VIEW);
                    });
        }
        content.revalidate();
        content.repaint();
    }

    private void heading(PanelText text) {
        JLabel label = new JLabel(text.in(session.language()));
        label.setFont(label.getFont().deriveFont(Font.BOLD));
        content.add(label, "newline, span 2, wrap, gaptop 4");
    }

    private void shape(PanelText text, ShapeOptions shape) {
        button(text.in(session.language()), null, () -> {
            session.options().shape(shape);
            take("brush");
        });
    }

    private void take(String tool) {
        Tools.named(tool).ifPresent(session::use);
        session.tell(Change.VIEW);
    }

    private void button(String text, Icon icon, Runnable action) {
        JButton button = new JButton(text, icon);
        button.putClientProperty(FlatClientProperties.MINIMUM_WIDTH, 40);
        button.setHorizontalAlignment(SwingConstants.LEADING);
        button.setToolTipText(text);
        button.addActionListener(event -> action.run());
        content.add(button, "wmin 40");
    }
}
