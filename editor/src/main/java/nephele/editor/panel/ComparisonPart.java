package nephele.editor.panel;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Component;
import java.util.Locale;
import java.util.function.Function;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.SwingConstants;
import nephele.editor.document.Registration;
import nephele.editor.panel.model.PanelText;
import nephele.editor.proving.ComparedPictures;
import nephele.editor.proving.TechniqueComparison;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.text.FieldWords;
import nephele.editor.text.Words;
import nephele.editor.widget.WordCell;
import nephele.engine.level.CloudTechnique;
import nephele.host.compare.ComparisonFigures;
import nephele.host.compare.TechniquePair;
import net.miginfocom.swing.MigLayout;

/** Two techniques of the selected cloud under a wipe, with their times and their difference, below its fields. */
final class ComparisonPart extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1;

    private final transient EditorSession session;
    private final transient TechniqueComparison comparison;
    private final transient Registration registration;
    private final JToggleButton toggle = new JToggleButton();
    private final JComboBox<CloudTechnique> left = new JComboBox<>(CloudTechnique.values());
    private final JComboBox<CloudTechnique> right = new JComboBox<>(CloudTechnique.values());
    private final WipePicture picture;
    private final JLabel leftTime = new JLabel(" ");
    private final JLabel rightTime = new JLabel(" ", SwingConstants.TRAILING);
    private final JLabel difference = new JLabel(" ");
    private final JPanel body =
            new JPanel(new MigLayout("insets 0, gap 4 3, fillx, wrap 2", "[grow, fill, sg][grow, fill, sg]"));
    private transient boolean isRefreshing;

    ComparisonPart(EditorSession session) {
        super(new MigLayout("insets 4 0 0 0, fillx, wrap 1, hidemode 3", "[grow, fill]"));
        this.session = session;
        comparison = session.proving().techniques();
        picture = new WipePicture(comparison::wipe);
        toggle.setName("compare-techniques");
        toggle.setHorizontalAlignment(SwingConstants.LEADING);
        toggle.putClientProperty(FlatClientProperties.BUTTON_TYPE, FlatClientProperties.BUTTON_TYPE_TOOLBAR_BUTTON);
        toggle.addActionListener(event -> toggle());
        listen(
                left,
                technique ->
                        new TechniquePair(technique, comparison.techniques().right()));
        listen(right, technique -> new TechniquePair(comparison.techniques().left(), technique));
        body.add(left, "wmin 40");
        body.add(right, "wmin 40");
        body.add(picture, "span 2, wmin 40");
        body.add(leftTime, "wmin 0");
        body.add(rightTime, "wmin 0");
        body.add(difference, "span 2, wmin 0");
        add(toggle);
        add(body);
        registration = session.listen(change -> {
            if (change != SessionChange.STATUS) {
                refresh();
            }
        });
        refresh();
    }

    private void listen(JComboBox<CloudTechnique> choice, Function<CloudTechnique, TechniquePair> pair) {
        choice.setRenderer(
                new WordCell<CloudTechnique>(value -> FieldWords.choice(value).in(session.language())));
        choice.addActionListener(event -> {
            if (!isRefreshing) {
                comparison.techniques(pair.apply((CloudTechnique) choice.getSelectedItem()));
            }
        });
    }

    private void toggle() {
        if (toggle.isSelected()) {
            comparison.show();
        } else {
            comparison.hide();
        }
    }

    private void refresh() {
        isRefreshing = true;
        boolean hasCloud = comparison.cloud().isPresent();
        setVisible(hasCloud);
        if (hasCloud) {
            toggle.setSelected(comparison.isVisible());
            toggle.setIcon(comparison.isVisible() ? PanelIcon.FOLD_OPEN : PanelIcon.FOLD_SHUT);
            toggle.setText(text(PanelText.COMPARE_TECHNIQUES.words()));
            body.setVisible(comparison.isVisible());
            name(left, PanelText.LEFT_TECHNIQUE);
            name(right, PanelText.RIGHT_TECHNIQUE);
            name(picture, PanelText.WIPE);
            picture.setToolTipText(text(PanelText.WIPE.words()));
            left.setSelectedItem(comparison.techniques().left());
            right.setSelectedItem(comparison.techniques().right());
            show(comparison.pictures().orElse(null));
        }
        isRefreshing = false;
    }

    private void name(Component component, PanelText text) {
        component.getAccessibleContext().setAccessibleName(text(text.words()));
    }

    private String text(Words words) {
        return words.in(session.language());
    }

    private void show(ComparedPictures pictures) {
        picture.show(pictures, comparison.wipe());
        ComparisonFigures figures = pictures == null ? null : pictures.figures();
        leftTime.setText(figures == null ? " " : millis(figures.leftMillis()));
        rightTime.setText(figures == null ? " " : millis(figures.rightMillis()));
        String reported = pictures == null
                ? text(PanelText.DRAWING.words())
                : figures == null ? pictures.failure() : text(difference(pictures));
        difference.setText(
                "<html>" + reported.replace("\n", "<br>") + (reported.contains("\n") ? "" : "<br>&nbsp;") + "</html>");
    }

    private static String millis(double millis) {
        return millis == 0 ? " " : String.format(Locale.ROOT, "%.1f ms", millis);
    }

    private static Words difference(ComparedPictures pictures) {
        var measured = pictures.figures().difference();
        if (measured.isNone()) {
            return PanelText.NO_DIFFERENCE.words();
        }
        return PanelText.DIFFERS.with(
                FieldWords.choice(pictures.techniques().tried()),
                FieldWords.choice(pictures.techniques().reference()),
                String.format(Locale.ROOT, "%.3f", measured.flip()),
                measured.lightPercent());
    }

    @Override
    public void close() {
        registration.close();
    }
}
