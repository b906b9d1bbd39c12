/** What several commands share: their options, and the base class that says where they report. */
package sunbeam.app.cli.options;
