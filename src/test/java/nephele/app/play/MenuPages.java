package nephele.app.play;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import nephele.app.play.hud.Area;
import nephele.app.play.hud.Hud;
import nephele.app.play.hud.HudContent;
import nephele.app.play.hud.Menu;
import nephele.app.settings.GameSetting;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Progress;
import nephele.app.settings.Settings;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.engine.level.Language;
import nephele.engine.level.json.LevelFile;
import nephele.engine.render.Capture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.pass.overlay.FontAtlas;
import nephele.engine.render.pass.overlay.OverlayPass;
import nephele.host.named.LevelCatalogue;
import nephele.host.named.LevelName;
import nephele.host.userfile.UserFolders;

/**
 * Every page of the menu, as players of each language see it. As a program it draws all of them, or those whose name
 * begins with a word, into a folder, in all windows or one: {@code FOLDER [WORD [WINDOW]]}.
 */
final class MenuPages {
    /**
     * The windows in which every page is whole: width and height in pixels. The first one has the least points; smaller
     * ones, in which letters are small too, and a high one follow at the end.
     */
    static final int[][] WINDOWS = {
        {640, 360}, {1280, 720}, {1920, 1080}, {2560, 1080}, {3840, 2160}, {400, 240}, {720, 1280}
    };

    private final PlayerFiles files;
    private final GameMenus menus;

    /** @param folder for the user's files; four levels are put there, one of them broken */
    MenuPages(Path folder) throws IOException {
        files = new PlayerFiles(new UserFolders(folder, folder, folder));
        Path own = Files.createDirectories(files.levels());
        Files.writeString(
                own.resolve("broken.json"),
                """
                {"format": "nephele-level", "version": 1,
                 "solids": [{"id": "a wall", "kind": "box", "centre": [0, 0], "size": [1, 2, 3]}],
                 "lights": [{"id": "lamp", "kind": "lantern"}], "gravity": 3, "player": {"feet": 7}, "exits": 4}""");
        Files.writeString(own.resolve("torn.zip"), "no zip", StandardCharsets.UTF_8);
        Files.writeString(
                own.resolve("my-first-room.json"),
                """
                {"format": "nephele-level", "version": 1, "name": "The long way round from the harbour to the Łódź gate",
                 "description": "%s", "par": {"seconds": 3600.5, "portals": 100}}"""
                        .formatted("A room with a view of rooms with views. ".repeat(40)));
        LevelFile.save(own.resolve("another.json"), level("levels/samples/exits.json"));
        menus = new GameMenus(files, LevelCatalogue.campaign(), LevelCatalogue.titles(), () -> Input.Device.KEYBOARD);
        files.keep(Progress.NONE
                .withFinished("01-courtyard.json", 3467, 0, 0)
                .withFinished("02-first-shot.json", 71_790, 12, 0));
    }

    private static nephele.engine.level.Level level(String file) {
        return LevelFile.open(file).level();
    }

    /** Returns all pages in a language, with all that they show of levels read. */
    List<Menu> in(Language language) {
        files.keep(files.settings().with(Settings.LANGUAGE, language));
        LevelName first = LevelCatalogue.first();
        List<Menu> all = new ArrayList<>();
        all.add(menus.title());
        all.add(menus.pause(first, "Find the way to the belvedere."));
        for (Menu.Page page : Menu.Page.values()) {
            all.add(read(menus.page(page)));
        }
        for (GameSetting.Group group : GameSetting.Group.values()) {
            all.add(menus.settings(group));
        }
        all.add(menus.keys(Control.FIRE_FIRST));
        for (int i = 0; i < LevelCatalogue.samples().groups().size(); i++) {
            all.add(menus.samples(i));
        }
        return all;
    }

    /** Returns a page once its levels are read. */
    private Menu read(Menu page) {
        Menu read = page;
        while (!menus.isRead()) {
            Thread.onSpinWait();
        }
        return menus.refreshed(read).orElse(read);
    }

    HudContent content(Menu page, Language language) {
        var keys = new HudContent.Keys(Settings.bindings(files.settings()), Input.Device.KEYBOARD, language);
        return new HudContent(page, HudContent.Page.NONE, List.of(), List.of(), null, null, null, keys, null);
    }

    /** Returns what a window of this size shows, in points. */
    static Area area(int[] window) {
        return Area.of(window[0], window[1], 1);
    }

    static double scale(int[] window) {
        return Area.pixelsPerPoint(window[0], window[1], 1);
    }

    public static void main(String[] arguments) throws IOException {
        Path out = Files.createDirectories(Path.of(arguments[0]));
        String word = arguments.length > 1 ? arguments[1] : "";
        MenuPages pages = new MenuPages(Files.createTempDirectory("pages"));
        FontAtlas letters = new FontAtlas();
        Hud hud = new Hud(letters);
        try (var gl = GlContext.offscreen();
                var overlay = new OverlayPass(gl, letters)) {
            for (int[] window :
                    arguments.length > 2 ? new int[][] {WINDOWS[Integer.parseInt(arguments[2])]} : WINDOWS) {
                try (var target = RenderTarget.picture(gl, "page", PixelFormat.RGBA8, window[0], window[1])) {
                    for (Language language : Language.values()) {
                        for (Menu page : pages.in(language)) {
                            if (!page.name().startsWith(word)) {
                                continue;
                            }
                            for (int row = 0; row < page.entries().size() - 1; row += 2) {
                                target.bind();
                                target.clear(0.3f, 0.4f, 0.5f);
                                HudContent content = pages.content(page.moved(row), language);
                                overlay.draw(hud.canvas(content, area(window), scale(window)), target);
                                Capture.png(
                                        target,
                                        out.resolve(page.name() + "-" + GameSetting.word(language) + "-" + window[0]
                                                + "x" + window[1] + "-" + row + ".png"));
                            }
                        }
                    }
                }
            }
        }
    }
}
