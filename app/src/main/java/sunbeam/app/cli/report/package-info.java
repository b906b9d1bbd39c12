/** Parts of reports that several commands share. */
package sunbeam.app.cli.report;
