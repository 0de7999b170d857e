package nephele.lab.technique;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import nephele.engine.level.CloudTechnique;
import nephele.lab.trade.HtmlDocument;

/** The page of one technique: how it works, its shader, its sample and its failure at the extremes. */
final class HandoutPage {
    private final TechniqueText text;
    private final Function<PictureCommand, Optional<String>> pictures;

    /** @param pictures returns a picture as the address of an image element; empty if its level does not exist */
    HandoutPage(TechniqueText text, Function<PictureCommand, Optional<String>> pictures) {
        this.text = text;
        this.pictures = pictures;
    }

    static String file(CloudTechnique technique) {
        return "technique-" + TechniqueText.word(technique) + ".html";
    }

    String html() {
        String title = text.one("title");
        return HtmlDocument.of(
                "Clouds by " + title,
                "<header class=\"handout\">\n" + links() + "<h1>" + title + "</h1>\n<p class=\"lead\">"
                        + text.one("lead") + "</p>\n</header>\n<main class=\"handout\">\n" + working() + shader()
                        + sample()
                        + failures() + facts() + "</main>\n");
    }

    private String links() {
        List<CloudTechnique> all = TechniqueText.ALL;
        int at = all.indexOf(text.technique());
        String before = at == 0 ? "" : link(all.get(at - 1), "← ", "");
        String after = at == all.size() - 1 ? "" : link(all.get(at + 1), "", " →");
        return "<nav><span>" + before + "</span><a href=\"index.html\">all techniques, measured</a><span>" + after
                + "</span></nav>\n";
    }

    private static String link(CloudTechnique technique, String before, String after) {
        return "<a href=\"" + file(technique) + "\">" + before + TechniqueText.word(technique) + after + "</a>";
    }

    private String working() {
        String lines = text.all("how").stream()
                .map(line -> "<li>" + line + "</li>")
                .collect(Collectors.joining("\n", "<ol>\n", "\n</ol>\n"));
        return "<section><h2>How it works</h2>\n" + lines + "<p class=\"formula\"><b>" + text.one("formula")
                + "</b><span>" + text.one("formula-source") + "</span></p></section>\n";
    }

    private String shader() {
        var html = new StringBuilder("<section><h2>Its shader</h2>\n<p>" + text.one("shader-words") + "</p>\n");
        for (String place : text.all("shader")) {
            String[] parts = place.split(" ");
            ShaderExcerpt.of(parts[0], parts[1]).ifPresent(excerpt -> html.append(excerpt.html()));
        }
        return html.append("</section>\n").toString();
    }

    private String sample() {
        PictureCommand sample = PictureCommand.of(text.one("sample"));
        return "<section><h2>Its sample</h2>\n" + figure(sample) + "</section>\n";
    }

    private String failures() {
        var html = new StringBuilder("<section><h2>Where it fails</h2>\n");
        for (TechniqueText.Failure failure : text.failures()) {
            html.append("<div class=\"failure\"><p>")
                    .append(failure.caption())
                    .append("</p><div class=\"pair\">")
                    .append(figure(failure.wrong()))
                    .append(figure(failure.right()))
                    .append("</div></div>\n");
        }
        return html.append("</section>\n").toString();
    }

    private String figure(PictureCommand picture) {
        Optional<String> address = pictures.apply(picture);
        String image = address.map(found -> "<img alt=\"" + plain(picture.caption()) + "\" src=\"" + found + "\">")
                .orElse("<p class=\"about\">no picture: the level is missing</p>");
        return "<figure>" + image + "<figcaption><b>" + picture.caption() + "</b><br><code>render "
                + HtmlDocument.text(picture.words()) + "</code></figcaption></figure>\n";
    }

    private static String plain(String html) {
        return html.replaceAll("<[^>]*>", "").replace("\"", "");
    }

    private String facts() {
        return "<section><h2>To write down</h2>\n<ul><li>Suited for " + text.one("suited") + " clouds.</li><li>Needs "
                + text.one("needs") + ".</li><li>" + text.one("draws") + " draws a frame, "
                + text.one("units") + " texture units.</li><li>An author sets " + text.one("parameters")
                + ".</li><li>Seen as in 2004: <span class=\"then\">" + text.one("then")
                + "</span></li></ul></section>\n";
    }
}
