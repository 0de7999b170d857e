package nephele.lab.technique;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import nephele.engine.level.CloudTechnique;
import nephele.lab.trade.HtmlDocument;

/** The page of one technique: how it works, its shader, its sample and its failure at the extremes. */
final class HandoutPage {
    private final TechniqueText text;
    private final Source pictures;

    /** A source of the pictures of pages. */
    interface Source {
        /** Returns a picture as the address of an image element; empty if its level does not exist. */
        Optional<String> address(PictureCommand command) throws IOException;
    }

    HandoutPage(TechniqueText text, Source pictures) {
        this.text = text;
        this.pictures = pictures;
    }

    static String file(CloudTechnique technique) {
        return "technique-" + TechniqueText.word(technique) + ".html";
    }

    String html() throws IOException {
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

    private String sample() throws IOException {
        TechniqueText.Picture sample = TechniqueText.Picture.of(text.one("sample"));
        return "<section><h2>Its sample</h2>\n" + figure(sample) + "</section>\n";
    }

    private String failures() throws IOException {
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

    private String figure(TechniqueText.Picture picture) throws IOException {
        Optional<String> address = pictures.address(picture.command());
        String image = address.map(found -> "<img alt=\"" + plain(picture.caption()) + "\" src=\"" + found + "\">")
                .orElse("<p class=\"about\">no picture: the level is missing</p>");
        return "<figure>" + image + "<figcaption><b>" + picture.caption() + "</b><br><code>render "
                + HtmlDocument.text(picture.command().words()) + "</code></figcaption></figure>\n";
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
