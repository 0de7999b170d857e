package nephele.editor.window.file;

import com.formdev.flatlaf.FlatClientProperties;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Image;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import javax.swing.DefaultListModel;
import javax.swing.ImageIcon;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;
import nephele.editor.file.FileRow;
import nephele.editor.text.Words;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import net.miginfocom.swing.MigLayout;

/** A list of versions of levels, with the picture and the place of the selected one beside it, and its buttons. */
final class PicturedList extends JPanel {
    private static final long serialVersionUID = 1;
    static final int PICTURE_WIDTH = 320;
    static final int PICTURE_HEIGHT = 200;

    private final DefaultListModel<FileRow> rows = new DefaultListModel<>();
    private final JList<FileRow> list = new JList<>(rows);
    private final JLabel picture = new JLabel("", SwingConstants.CENTER);
    private final JLabel place = new JLabel(" ");
    private final transient Language language;
    private final transient IntFunction<Optional<BufferedImage>> pictures;

    /** @param pictures returns that of a row */
    PicturedList(Words name, Language language, IntFunction<Optional<BufferedImage>> pictures) {
        super(new MigLayout("insets 0, fill", "[grow, fill, 320lp:380lp][fill]", "[top][]"));
        this.language = language;
        this.pictures = pictures;
        list.setName("rows");
        list.getAccessibleContext().setAccessibleName(name.in(language));
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer((all, row, index, isSelected, hasFocus) -> cell(row, isSelected));
        list.addListSelectionListener(event -> showSelected());
        picture.setName("picture");
        place.setName("place");
        place.putClientProperty(FlatClientProperties.STYLE_CLASS, "small");
        JScrollPane scroll = new JScrollPane(list);
        scroll.setHorizontalScrollBarPolicy(JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        add(scroll, "grow, h " + PICTURE_HEIGHT + "lp!");
        add(picture, "w " + PICTURE_WIDTH + "lp!, h " + PICTURE_HEIGHT + "lp!, wrap");
        add(place, "span, growx, wmin 0");
    }

    /** Returns the plan of a level in the size of the pictures. */
    static BufferedImage plan(Level level) {
        return PlanPicture.of(level, UIScale.scale(PICTURE_WIDTH), UIScale.scale(PICTURE_HEIGHT));
    }

    /** Shows other rows, and keeps the place of the selection as far as possible. */
    void show(List<FileRow> next) {
        int selected = Math.max(0, list.getSelectedIndex());
        rows.clear();
        next.forEach(rows::addElement);
        list.setSelectedIndex(Math.min(selected, next.size() - 1));
        showSelected();
    }

    int selected() {
        return list.getSelectedIndex();
    }

    JList<FileRow> rowList() {
        return list;
    }

    /** Returns a button with a text, by whose constant it is named, that runs an effect. */
    JButton button(FileDialogText text, Runnable effect) {
        JButton button = new JButton(text.in(language));
        button.setName(text.name());
        button.addActionListener(event -> effect.run());
        return button;
    }

    private void showSelected() {
        int index = list.getSelectedIndex();
        Optional<BufferedImage> image = index < 0 ? Optional.empty() : pictures.apply(index);
        picture.setIcon(image.map(PicturedList::icon).orElse(null));
        picture.setText(image.isPresent() ? "" : FileDialogText.NO_PICTURE.in(language));
        String title = index < 0 ? "" : rows.get(index).title().in(language);
        picture.getAccessibleContext()
                .setAccessibleName(FileDialogText.PICTURE_OF.with(title).in(language));
        String path = index < 0 ? "" : rows.get(index).place().in(language);
        place.setText(path.isEmpty() ? " " : path);
        place.setToolTipText(path.isEmpty() ? null : path);
    }

    private static ImageIcon icon(BufferedImage image) {
        double fit = Math.min(
                (double) UIScale.scale(PICTURE_WIDTH) / image.getWidth(),
                (double) UIScale.scale(PICTURE_HEIGHT) / image.getHeight());
        int width = (int) Math.max(1, fit * image.getWidth());
        int height = (int) Math.max(1, fit * image.getHeight());
        return new ImageIcon(image.getScaledInstance(width, height, Image.SCALE_SMOOTH));
    }

    private Component cell(FileRow row, boolean isSelected) {
        JPanel cell = new JPanel(new MigLayout("insets 5 8 5 8, fillx, wrap 1, gapy 1", "[0:pref:, grow]")) {
            private static final long serialVersionUID = 1;

            /** Lays itself out without a window, too, as for pictures of the dialogue. */
            @Override
            public void validate() {
                super.validate();
                doLayout();
            }
        };
        cell.setBackground(isSelected ? list.getSelectionBackground() : list.getBackground());
        JLabel title = new JLabel(row.title().in(language));
        title.putClientProperty(FlatClientProperties.STYLE, "font: bold");
        JLabel detail = new JLabel(row.detail().in(language));
        title.setForeground(isSelected ? list.getSelectionForeground() : list.getForeground());
        detail.setForeground(title.getForeground());
        cell.add(title, "growx, wmin 0");
        cell.add(detail, "growx, wmin 0");
        cell.getAccessibleContext().setAccessibleName(title.getText() + ", " + detail.getText());
        return cell;
    }
}
